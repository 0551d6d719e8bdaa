#include <gtest/gtest.h>

#include <chrono>
#include <future>

#include "app/viewer/work.h"
#include "core/render/scene_tree.h"

namespace bspview {
namespace {

using Origin = BuiltTree::Origin;

std::shared_ptr<const LoadedScene> open(const std::string& source) {
  std::shared_ptr<const LoadedScene> scene;
  EXPECT_TRUE(open_scene({source}, {}, [&](auto loaded) { scene = loaded; }).ok());
  return scene;
}

/// Asks for trees of one scene, one after the other.
struct Wisher {
  std::shared_ptr<const LoadedScene> scene = open("spd:gears:2");
  TreeWork work;

  std::shared_ptr<const BuiltTree> want(const BuildParams& params) {
    std::shared_ptr<const BuiltTree> built;
    EXPECT_TRUE(work({scene, params}, {}, [&](auto tree) { built = tree; }).ok());
    const auto rebuilt = build_scene_tree(scene->scene, params);
    EXPECT_EQ(built->tree.nodes, rebuilt->nodes);
    EXPECT_EQ(built->tree.references, rebuilt->references);
    EXPECT_EQ(built->tree.memory_limit_reached, rebuilt->memory_limit_reached);
    EXPECT_EQ(built->tree.params, params);
    EXPECT_EQ(built->stats, tree_stats(*rebuilt));
    return built;
  }
};

TEST(TreeWork, LimitsOfACostDrivenBuilderAreCutFromTheFirstTreeOn) {
  Wisher wisher;
  for (const Builder builder : {Builder::mb, Builder::sah}) {
    EXPECT_EQ(wisher.want({.builder = builder})->origin, Origin::build);
    EXPECT_EQ(wisher.want({.builder = builder, .max_depth = 9})->origin, Origin::cut);
    EXPECT_EQ(wisher.want({.builder = builder, .leaf_size = 7})->origin, Origin::cut);
    EXPECT_EQ(wisher.want({.builder = builder})->origin, Origin::build) << "the same one";
  }
}

TEST(TreeWork, AfterOneMoveBeyondTheFirstTreeEverythingIsCut) {
  Wisher wisher;
  wisher.want({.max_depth = 10, .leaf_size = 5});
  for (const int depth : {11, 30, 64}) {
    EXPECT_EQ(wisher.want({.max_depth = depth, .leaf_size = 5})->origin, Origin::cut);
  }
  EXPECT_EQ(wisher.want({.max_depth = 10, .leaf_size = 1})->origin, Origin::cut);
}

TEST(TreeWork, LimitsOfOtherBuildersAreCutOnceOneWasMoved) {
  Wisher wisher;
  for (const Builder builder : {Builder::median, Builder::median_longest, Builder::object_median}) {
    const auto want = [&](int depth) {
      return wisher.want({.builder = builder, .max_depth = depth})->origin;
    };
    EXPECT_EQ(want(12), Origin::build);
    EXPECT_EQ(want(11), Origin::build);
    EXPECT_EQ(want(9), Origin::cut);
    EXPECT_EQ(want(11), Origin::build) << "the same one";
    EXPECT_EQ(want(12), Origin::build) << "no tree without end";
  }
}

TEST(TreeWork, WhatChoosesPlanesIsRebuilt) {
  Wisher wisher;
  for (const BuildParams& params : {BuildParams{},
                                    {.cost_intersection = 2.0f},
                                    {.empty_bonus = 0.3f},
                                    {.clip = false},
                                    {.builder = Builder::naive}}) {
    EXPECT_EQ(wisher.want(params)->origin, Origin::build);
  }
}

TEST(TreeWork, CostsAreCutOnceTheyWereMovedFurther) {
  Wisher wisher;
  for (const Builder builder : {Builder::mb, Builder::sah, Builder::sah_binned}) {
    const auto want = [&](float node, std::optional<float> test = {}) {
      const BuildParams params{
          .builder = builder, .cost_traversal = node, .cost_intersection = test};
      return wisher.want(params)->origin;
    };
    EXPECT_EQ(want(1.0f), Origin::build);
    EXPECT_EQ(want(2.0f), Origin::cut);
    EXPECT_EQ(want(0.5f), Origin::cut) << "of a larger tree, which is built once";
    EXPECT_EQ(want(0.4f), Origin::cut);
    EXPECT_EQ(want(1.0f), Origin::cut);
    EXPECT_EQ(want(1.0f, 3.0f), Origin::build) << "one for all objects";
    EXPECT_EQ(want(1.0f, 2.0f), Origin::cut);
    EXPECT_EQ(want(1.0f, 4.0f), Origin::cut) << "of a larger tree";
    EXPECT_EQ(want(2.0f, 8.5f), Origin::cut);
  }
}

TEST(TreeWork, ATreeThatDoesNotFitTheMemoryLimitIsAsBuilt) {
  Wisher wisher;
  const std::size_t bytes = wisher.want({})->tree.bytes();
  for (const std::size_t limit : {bytes, bytes - 1, bytes / 3, std::size_t{0}, 2 * bytes}) {
    wisher.want({.memory_limit = limit});
    wisher.want({.max_depth = 8, .memory_limit = limit});
    wisher.want({.max_depth = 60, .memory_limit = limit});
  }
}

TEST(TreeWork, AnotherSceneIsAnotherTree) {
  Wisher wisher;
  wisher.want({});
  wisher.scene = open("spd:balls:2");
  EXPECT_EQ(wisher.want({.max_depth = 9})->origin, Origin::build);
}

TEST(TreeWork, WhatIsBuiltServesAllThatCanBeCutFromIt) {
  const auto scene = open("spd:mount:8");
  const TreeRequest request{scene, {.max_depth = 20, .leaf_size = 2}};
  const auto with = [&](auto change) {
    TreeRequest wish = request;
    change(wish.params);
    return wish;
  };
  TreeWork work;
  EXPECT_FALSE(work.serves(request));
  std::stop_source stop;
  const auto build = [&] { return work(request, stop.get_token(), [](const auto&) {}).ok(); };
  std::future<bool> built = std::async(std::launch::async, build);
  while (!work.serves(request)) std::this_thread::yield();
  EXPECT_TRUE(work.serves(with([](BuildParams& p) { p.max_depth = 3; })));
  EXPECT_TRUE(work.serves(with([](BuildParams& p) { p.leaf_size = 3; })));
  EXPECT_FALSE(work.serves(with([](BuildParams& p) { p.max_depth = 21; })));
  EXPECT_FALSE(work.serves(with([](BuildParams& p) { p.leaf_size = 1; })));
  EXPECT_TRUE(work.serves(with([](BuildParams& p) { p.cost_traversal = 3.0f; })));
  EXPECT_FALSE(work.serves(with([](BuildParams& p) { p.cost_traversal = 0.9f; })));
  EXPECT_FALSE(work.serves(with([](BuildParams& p) { p.cost_intersection = 0.01f; })));
  EXPECT_FALSE(work.serves(with([](BuildParams& p) { p.empty_bonus = 0.2f; })));
  EXPECT_FALSE(work.serves(with([](BuildParams& p) { p.builder = Builder::median; })));
  EXPECT_FALSE(work.serves({open("spd:balls:1"), request.params}));
  stop.request_stop();
  EXPECT_FALSE(built.get());
  EXPECT_FALSE(work.serves(request));
}

TEST(TreeWork, WhatIsCutServesOtherPartsOfTheSameTree) {
  const auto scene = open("spd:gears:2");
  TreeWork work;
  const TreeRequest whole{scene, {}}, part{scene, {.max_depth = 9}}, other{scene, {.clip = false}};
  int cuts = 0;
  const auto publish = [&](const auto& built) {
    if (built->origin != Origin::cut) return;
    ++cuts;
    EXPECT_TRUE(work.serves(whole));
    EXPECT_FALSE(work.serves(other));
  };
  EXPECT_TRUE(work(whole, {}, publish).ok());
  EXPECT_TRUE(work(part, {}, publish).ok());
  EXPECT_EQ(cuts, 1);
  EXPECT_FALSE(work.serves(whole)) << "nothing is under way";
}

TEST(TreeWork, AStopPublishesNothingAndLeavesWhatOthersAreCutFrom) {
  Wisher wisher;
  wisher.want({});
  std::stop_source stop;
  stop.request_stop();
  for (const BuildParams& params : {BuildParams{}, {.max_depth = 9}, {.max_depth = 64}}) {
    const auto answer =
        wisher.work({wisher.scene, params}, stop.get_token(), [](const auto&) { ADD_FAILURE(); });
    ASSERT_FALSE(answer.ok());
    EXPECT_EQ(answer.error().message, "stopped");
  }
  EXPECT_EQ(wisher.want({.max_depth = 9})->origin, Origin::cut);
}

TEST(TreeWork, WhatALargeTreeIsBuiltAnewForIsSketchedFirst) {
  const auto scene = open("spd:mount:7");
  TreeWork work;
  std::vector<std::shared_ptr<const BuiltTree>> published;
  const auto want = [&](const BuildParams& params) {
    published.clear();
    const auto publish = [&](auto tree) { published.push_back(tree); };
    EXPECT_TRUE(work({scene, params}, {}, publish).ok());
    return published.size();
  };
  EXPECT_EQ(want({.builder = Builder::mb}), 1u);
  EXPECT_EQ(want({}), 1u) << "another builder";
  EXPECT_EQ(want({.cost_traversal = 2.0f}), 1u) << "a cut";
  ASSERT_EQ(want({.empty_bonus = 0.3f}), 2u);
  EXPECT_EQ(published[0]->origin, Origin::sketch);
  const BuildParams binned{.builder = Builder::sah_binned, .empty_bonus = 0.3f};
  EXPECT_EQ(published[0]->request.params, binned);
  EXPECT_EQ(published[0]->tree.nodes, build_scene_tree(scene->scene, binned)->nodes);
  EXPECT_EQ(published[1]->origin, Origin::build);
  EXPECT_EQ(published[1]->tree.nodes, build_scene_tree(scene->scene, {.empty_bonus = 0.3f})->nodes);
  EXPECT_EQ(want({.max_depth = 9, .empty_bonus = 0.3f}), 1u) << "a cut";
  EXPECT_EQ(want({.cost_traversal = 0.5f, .empty_bonus = 0.3f}), 1u) << "of a larger tree";
  EXPECT_EQ(want({.max_depth = 60, .cost_traversal = 0.2f, .empty_bonus = 0.3f}), 1u)
      << "a cut of that";
}

TEST(TreeWork, AStoppedSketchIsNotShown) {
  const auto scene = open("spd:mount:7");
  TreeWork work;
  EXPECT_TRUE(work({scene, {}}, {}, [](const auto&) {}).ok());
  std::stop_source stop;
  stop.request_stop();
  const auto publish = [](const auto&) { ADD_FAILURE(); };
  EXPECT_FALSE(work({scene, {.empty_bonus = 0.3f}}, stop.get_token(), publish).ok());
}

TEST(TreeWork, SaysHowFarABuildIsAndNeverGoesBack) {
  TreeRequest request{open("spd:mount:8"), {}};
  TreeWork work;
  const auto build = [&] { return work(request, {}, [](const auto&) {}).ok(); };
  EXPECT_TRUE(build());
  EXPECT_EQ(work.progress(), 0.0);
  request.params.empty_bonus = 0.3f;  // a sketch, then the tree
  std::future<bool> built = std::async(std::launch::async, build);
  double last = 0.0;
  while (built.wait_for(std::chrono::milliseconds(1)) != std::future_status::ready) {
    const double now = work.progress();
    if (now == 0.0) continue;  // before the build, or behind it
    EXPECT_GE(now, last);
    last = now;
  }
  EXPECT_TRUE(built.get());
  EXPECT_GT(last, 0.0);
  EXPECT_LT(last, 1.0 + 1e-9);
  EXPECT_EQ(work.progress(), 0.0);
}

}  // namespace
}  // namespace bspview
