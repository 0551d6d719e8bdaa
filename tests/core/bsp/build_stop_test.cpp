#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <numeric>
#include <thread>

#include "core/bsp/branch.h"
#include "core/bsp/build.h"
#include "tests/support/box_sets.h"
#include "tests/support/random.h"

namespace bspview {
namespace {

using test::BoxSet;

constexpr std::array clipping_builders{Builder::median_longest, Builder::object_median, Builder::mb,
                                       Builder::sah, Builder::sah_binned};

/// The input of `set`, with `on_clip` called before each clipping with the number of those so far.
template <class OnClip>
BuildInput watched(const BoxSet& set, std::atomic<int>& clips, OnClip on_clip) {
  return {set.boxes(), [&set, &clips, on_clip](std::uint32_t object, const Aabb& cell) {
            on_clip(clips.fetch_add(1));
            return intersection(set.boxes()[object], cell);
          }};
}

int count_clips(const BoxSet& set, const BuildParams& params) {
  std::atomic<int> clips = 0;
  EXPECT_TRUE(build_tree(watched(set, clips, [](int) {}), params).ok());
  return clips;
}

TEST(BuildStop, AStopBeforeTheStartBuildsNothing) {
  const BoxSet set = test::random_boxes(1000, 1);
  std::stop_source stop;
  stop.request_stop();
  for (const Builder builder : clipping_builders) {
    std::atomic<int> clips = 0;
    const auto tree =
        build_tree(watched(set, clips, [](int) {}), {.builder = builder}, stop.get_token());
    ASSERT_FALSE(tree.ok());
    EXPECT_EQ(tree.error().message, "stopped");
    EXPECT_EQ(clips, 0);
  }
}

TEST(BuildStop, AStopAtARandomPointEndsTheBuildAfterFewMoreObjects) {
  const BoxSet set = test::random_boxes(5000, 2);
  test::Random random(3);
  for (const Builder builder : clipping_builders) {
    const BuildParams params{.builder = builder, .max_depth = 14, .threads = 2};
    const int all = count_clips(set, params);
    for (int i = 0; i < 10; ++i) {
      std::stop_source stop;
      std::atomic<int> clips = 0;
      const int last = random.below(all);
      const auto request = [&](int clip) {
        if (clip == last) stop.request_stop();
      };
      const auto tree = build_tree(watched(set, clips, request), params, stop.get_token());
      ASSERT_FALSE(tree.ok()) << name_of(builder) << ", clip " << last << " of " << all;
      EXPECT_EQ(tree.error().message, "stopped");
      EXPECT_LE(clips - last, 5000) << name_of(builder);
    }
  }
}

TEST(BuildStop, AStopEndsTheJoiningOfBranches) {
  std::stop_source stop;
  const BuildInput none;
  const BuildJob job{.input = none, .stop = stop.get_token()};
  Branch whole, part;
  whole.nodes.push_back(Node::make_leaf(0, 0));
  part.nodes.push_back(Node::make_leaf(0, 1));
  part.references.push_back(7);
  stop.request_stop();
  EXPECT_THROW(splice(job, whole, 0, part), BuildStopped);
  EXPECT_TRUE(whole.references.empty());
}

TEST(BuildStop, AStopEndsTheMoveToMoreRoom) {
  std::stop_source stop;
  const BuildInput none;
  const BuildJob job{.input = none, .stop = stop.get_token()};
  References references;
  references.resize(100'000);
  std::iota(references.begin(), references.end(), 0u);
  const References before = references;
  make_room(job, references, before.size() + 1);
  EXPECT_GE(references.capacity(), 2 * before.size() + 1);
  EXPECT_EQ(references, before);
  stop.request_stop();
  EXPECT_THROW(make_room(job, references, references.capacity()), BuildStopped);
  EXPECT_EQ(references, before);
}

TEST(BuildStop, AStopFromAnotherThreadLeavesATreeOrTheError) {
  const BoxSet set = test::random_boxes(20'000, 4);
  test::Random random(5);
  for (int i = 0; i < 40; ++i) {
    std::stop_source stop;
    std::jthread other([&stop, wait = random.below(30'000)] {
      std::this_thread::sleep_for(std::chrono::microseconds(wait));
      stop.request_stop();
    });
    const auto tree = build_tree(set.input(), {.builder = Builder::sah}, stop.get_token());
    EXPECT_EQ(tree.ok() ? "stopped" : tree.error().message, "stopped");
  }
}

TEST(BuildStop, WithoutMemoryThereIsASentence) {
  const BoxSet set = test::random_boxes(5000, 6);
  test::Random random(7);
  for (const Builder builder : clipping_builders) {
    const BuildParams params{.builder = builder, .max_depth = 14, .threads = 2};
    const int all = count_clips(set, params);
    for (int i = 0; i < 5; ++i) {
      std::atomic<int> clips = 0;
      const int last = random.below(all);
      const auto fail = [&](int clip) {
        if (clip >= last) throw std::bad_alloc();
      };
      const auto tree = build_tree(watched(set, clips, fail), params);
      ASSERT_FALSE(tree.ok()) << name_of(builder);
      EXPECT_EQ(tree.error().message, "not enough memory for the tree");
    }
  }
}

}  // namespace
}  // namespace bspview
