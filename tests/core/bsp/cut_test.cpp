#include "core/bsp/cut.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/bsp/stats.h"
#include "core/render/scene_tree.h"
#include "core/scene/spd.h"
#include "tests/support/box_sets.h"
#include "tests/support/builds.h"
#include "tests/support/random.h"

namespace bspview {
namespace {

using test::describe;
using test::every_way;

constexpr InnerLimit room{std::size_t{1} << 28};

MaximalTree whole_tree(const BuildInput& input, const BuildParams& params) {
  auto whole = build_maximal_tree(input, params, room);
  EXPECT_TRUE(whole.ok());
  return *std::move(whole);
}

void expect_cut_is_rebuilt(const BuildInput& input, const MaximalTree& whole,
                           const BuildParams& params) {
  SCOPED_TRACE(fmt::format("{}, depth {}, leaf size {}", describe(params),
                           params.max_depth.value_or(-1), params.leaf_size));
  const auto rebuilt = build_tree(input, params);
  const auto part = cut(whole, params);
  ASSERT_TRUE(rebuilt.ok());
  ASSERT_TRUE(part);
  test::expect_same(*part, *rebuilt);
  EXPECT_EQ(part->box, rebuilt->box);
  EXPECT_EQ(part->object_count, rebuilt->object_count);
  EXPECT_EQ(part->params, rebuilt->params);
  EXPECT_EQ(part->max_depth, rebuilt->max_depth);
  EXPECT_EQ(part->cost_intersection, rebuilt->cost_intersection);
  EXPECT_EQ(part->naive, rebuilt->naive);
}

/// Limits within depth 13, leaf size 1 and the ratio of the costs, C_I aside: where it is given, it
/// is less. Costs must not matter to builders without any.
BuildParams random_limits(BuildParams params, test::Random& random) {
  params.max_depth = random.below(15) - 1;
  params.leaf_size = random.below(3) == 0 ? random.below(2) : random.below(40);
  params.threads = 1 + random.below(2);
  if (has_costs(params.builder)) {
    params.cost_traversal *=
        1.0f + random.between(0.0f, 3.0f) * static_cast<float>(random.below(2));
    if (params.cost_intersection) *params.cost_intersection *= random.unit();
    return params;
  }
  params.cost_traversal = random.between(0.0f, 4.0f);
  params.cost_intersection = random.between(0.0f, 4.0f);
  params.empty_bonus = random.unit();
  return params;
}

/// The largest standard scene of that name with at most `most` objects, or else the smallest.
Scene small_spd(const SpdScene& spd, double most) {
  if (!spd.has_size) return *make_spd(spd.name);
  int size = 1;
  while (*count_spd_objects(spd.name, size + 1) <= most) ++size;
  return *make_spd(spd.name, size);
}

class CutOfScene : public testing::TestWithParam<SpdScene> {};

TEST_P(CutOfScene, IsTheRebuiltTreeNodeForNode) {
  const Scene scene = small_spd(GetParam(), 1500.0);
  const SceneBuildInput objects(scene);
  const BuildInput input = objects.input();
  test::Random random(2016);
  for (const BuildParams& costs : {BuildParams{},
                                   {.cost_traversal = 0.1f},
                                   {.cost_traversal = 0.2f, .cost_intersection = 1.5f}}) {
    BuildParams shallow = costs;
    shallow.max_depth = 13;
    for (const BuildParams& params : every_way(shallow)) {
      const MaximalTree whole = whole_tree(input, params);
      for (int i = 0; i < 6; ++i) {
        expect_cut_is_rebuilt(input, whole, random_limits(params, random));
      }
    }
  }
}

TEST(Cut, ByEveryRatioOfCostsIsTheRebuiltTree) {
  const test::BoxSet set = test::random_boxes(3000, 5);
  for (const Builder builder : {Builder::mb, Builder::sah, Builder::sah_binned}) {
    const MaximalTree whole = whole_tree(
        set.input(), {.builder = builder, .cost_traversal = 0.0f, .cost_intersection = 2.0f});
    std::size_t nodes = whole.tree->nodes.size() + 1;
    for (const float node : {0.0f, 0.01f, 0.3f, 3.0f, 30.0f, 1000.0f, 1e30f}) {
      const BuildParams params{
          .builder = builder, .cost_traversal = node, .cost_intersection = 2.0f};
      expect_cut_is_rebuilt(set.input(), whole, params);
      const std::size_t fewer = cut(whole, params)->nodes.size();
      EXPECT_LE(fewer, nodes) << node;
      nodes = fewer;
    }
    EXPECT_EQ(nodes, 1u);
  }
}

INSTANTIATE_TEST_SUITE_P(Every, CutOfScene, testing::ValuesIn(spd_scenes()),
                         [](const auto& scene) { return std::string(scene.param.name); });

TEST(Cut, OfHardObjectsIsTheRebuiltTree) {
  test::Random random(7);
  for (const test::HardCase& hard : test::hard_cases(150, 5)) {
    SCOPED_TRACE(hard.name);
    const BuildInput input = hard.set.input();
    for (const BuildParams& params : every_way({.max_depth = 13})) {
      const MaximalTree whole = whole_tree(input, params);
      for (int i = 0; i < 3; ++i) {
        expect_cut_is_rebuilt(input, whole, random_limits(params, random));
      }
    }
  }
}

TEST(Cut, OfATreeThatManyThreadsBuiltIsTheRebuiltTree) {
  const test::BoxSet set = test::random_boxes(20'000, 3);
  const BuildInput input = set.input();
  const MaximalTree whole = whole_tree(input, {.threads = 4});
  for (const BuildParams& params :
       {BuildParams{.leaf_size = 6}, {.max_depth = 9}, {.max_depth = 15, .leaf_size = 3}}) {
    expect_cut_is_rebuilt(input, whole, params);
  }
}

TEST(Cut, HasTheObjectsThatClippingLosesFurtherDown) {
  const test::BoxSet set = test::random_boxes(400, 9);
  // The part of an object in a thin cell is not found: it is in the node and in neither child.
  const BuildInput input{set.boxes(), [&](std::uint32_t object, const Aabb& cell) {
                           const bool thin = cell.hi.x - cell.lo.x < 0.3f;
                           return thin ? Aabb{} : intersection(set.boxes()[object], cell);
                         }};
  for (const BuildParams& params : every_way({.max_depth = 13})) {
    const MaximalTree whole = whole_tree(input, params);
    for (int depth = 0; depth <= 13; ++depth) {
      BuildParams shallow = params;
      shallow.max_depth = depth;
      expect_cut_is_rebuilt(input, whole, shallow);
    }
  }
}

TEST(Cut, OfATreeThatNoDepthStoppedMayBeDeeper) {
  const test::BoxSet set = test::random_boxes(300, 1);
  const MaximalTree whole = whole_tree(set.input(), {.max_depth = 50});
  const int deepest = tree_stats(*whole.tree).deepest_leaf;
  ASSERT_LT(deepest, 50);
  expect_cut_is_rebuilt(set.input(), whole, {.max_depth = 60});
  expect_cut_is_rebuilt(set.input(), whole, {.max_depth = deepest});
}

TEST(Cut, HasNoMoreThanTheWholeTree) {
  const test::BoxSet set = test::random_boxes(500, 2);
  const BuildParams params{.builder = Builder::mb, .max_depth = 8, .leaf_size = 3};
  const MaximalTree whole = whole_tree(set.input(), params);
  ASSERT_TRUE(cut(whole, params));
  const auto with = [&](auto change) {
    BuildParams other = params;
    change(other);
    return cut(whole, other).has_value();
  };
  EXPECT_TRUE(with([](BuildParams& p) { p.threads = 3; }));
  EXPECT_TRUE(with([](BuildParams& p) { p.clip = true; }));
  EXPECT_FALSE(with([](BuildParams& p) { p.max_depth = 9; }));
  EXPECT_FALSE(with([](BuildParams& p) { p.leaf_size = 2; }));
  EXPECT_FALSE(with([](BuildParams& p) { p.clip = false; }));
  EXPECT_FALSE(with([](BuildParams& p) { p.builder = Builder::sah; }));
  EXPECT_TRUE(with([](BuildParams& p) { p.cost_traversal = 2.0f; }));
  EXPECT_FALSE(with([](BuildParams& p) { p.cost_traversal = 0.9f; }));
  EXPECT_FALSE(with([](BuildParams& p) { p.cost_intersection = 2.0f; })) << "one for all objects";
  EXPECT_FALSE(with([](BuildParams& p) { p.empty_bonus = 0.2f; }));
}

TEST(Cut, AStopLeavesNothing) {
  const test::BoxSet set = test::random_boxes(500, 3);
  const MaximalTree whole = whole_tree(set.input(), {.max_depth = 50});
  std::stop_source stop;
  const auto is_cut = [&](const BuildParams& params) {
    return cut(whole, params, stop.get_token()).has_value();
  };
  const BuildParams part{.max_depth = 9}, deeper{.max_depth = 60};
  EXPECT_TRUE(is_cut(part) && is_cut(deeper));
  stop.request_stop();
  EXPECT_FALSE(is_cut(part) || is_cut(deeper));
}

TEST(Cut, KeepsToTheMemoryLimit) {
  const test::BoxSet set = test::random_boxes(500, 4);
  const MaximalTree whole = whole_tree(set.input(), {});
  BuildParams params{.leaf_size = 2};
  params.memory_limit = cut(whole, params)->bytes();
  expect_cut_is_rebuilt(set.input(), whole, params);
  --params.memory_limit;
  EXPECT_FALSE(cut(whole, params));
  params.max_depth = 0;  // a lone root is made whatever it takes
  params.memory_limit = 0;
  expect_cut_is_rebuilt(set.input(), whole, params);
  params.builder = Builder::naive;
  const MaximalTree naive = whole_tree(set.input(), {.builder = Builder::naive});
  params.max_depth = 9;
  expect_cut_is_rebuilt(set.input(), naive, params);
}

TEST(Cut, NeedsTheObjectsOfTheInnerNodes) {
  const test::BoxSet set = test::random_boxes(500, 6);
  const MaximalTree whole = whole_tree(set.input(), {});
  const auto fits = build_maximal_tree(set.input(), {}, {whole.inner->meter.bytes()});
  const auto lacks = build_maximal_tree(set.input(), {}, {whole.inner->meter.bytes() - 1});
  ASSERT_TRUE(fits.ok() && lacks.ok());
  EXPECT_TRUE(cut(*fits, {}));
  EXPECT_FALSE(cut(*lacks, {}));
  test::expect_same(*fits->tree, *lacks->tree);

  BuildParams params;
  params.memory_limit = whole.tree->bytes() / 2;
  const auto limited = build_maximal_tree(set.input(), params, room);
  ASSERT_TRUE(limited.ok());
  EXPECT_TRUE(limited->tree->memory_limit_reached);
  EXPECT_FALSE(cut(*limited, params));
}

TEST(Cut, ATreeWithTheObjectsOfItsInnerNodesOrNoneIsOneOrAnError) {
  const test::BoxSet set = test::random_boxes(500, 6);
  const MaximalTree whole = whole_tree(set.input(), {.threads = 2});
  const auto build = [&](std::size_t inner_bytes, std::size_t tree_bytes) {
    return build_maximal_tree(set.input(), {.memory_limit = tree_bytes, .threads = 2},
                              {inner_bytes, InnerLimit::WhenPassed::do_not_build});
  };
  const std::size_t inner = whole.inner->meter.bytes(), tree = whole.tree->bytes();
  EXPECT_TRUE(build(inner, tree).ok());
  for (const auto& [inner_bytes, tree_bytes] :
       {std::pair{inner - 1, tree}, {inner, tree - 1}, {std::size_t{0}, tree}}) {
    const auto none = build(inner_bytes, tree_bytes);
    ASSERT_FALSE(none.ok());
    EXPECT_EQ(none.error().message, "what the inner nodes hold takes too much memory");
  }
}

TEST(Cut, AStoppedBuildIsNoTree) {
  std::stop_source stop;
  stop.request_stop();
  const test::BoxSet set = test::random_boxes(10, 6);
  EXPECT_FALSE(build_maximal_tree(set.input(), {}, room, stop.get_token()).ok());
}

}  // namespace
}  // namespace bspview
