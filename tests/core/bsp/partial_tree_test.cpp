#include "core/bsp/partial_tree.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/bsp/validate.h"
#include "tests/support/box_sets.h"
#include "tests/support/builds.h"

namespace bspview {
namespace {

using test::BoxSet;

constexpr int many = 50'000;  // so many that the upper planes are those of a sample

void expect_deferred(const PartialTree& partial, std::size_t leaf_size) {
  ASSERT_EQ(partial.deferred.size(), partial.tree.unbuilt.size());
  for (std::size_t i = 0; i < partial.deferred.size(); ++i) {
    const DeferredLeaf& leaf = partial.deferred[i];
    EXPECT_EQ(leaf.node, partial.tree.unbuilt[i]);
    EXPECT_GT(leaf.parts.size(), leaf_size);
    const auto objects = partial.tree.objects_of(partial.tree.nodes[leaf.node]);
    EXPECT_TRUE(std::ranges::equal(objects, leaf.parts, {}, {}, &ObjectPart::object));
    EXPECT_TRUE(std::ranges::is_sorted(objects));
  }
}

TEST(PartialTree, HardScenesHaveUpperPartsThatAreValid) {
  for (const test::HardCase& hard : test::hard_cases(many, 7)) {
    SCOPED_TRACE(hard.name);
    const auto partial = build_partial_tree(hard.set.input(), {});
    ASSERT_TRUE(partial.ok());
    const auto valid = validate(partial->tree, hard.set.input());
    EXPECT_TRUE(valid.ok()) << valid.error().message;
    expect_deferred(*partial, 1);
  }
}

TEST(PartialTree, UpperPartsAreTheSameForAnyNumberOfThreads) {
  const BoxSet set = test::random_boxes(many, 5);
  const auto one = build_partial_tree(set.input(), {.threads = 1});
  ASSERT_TRUE(one.ok());
  EXPECT_GT(one->deferred.size(), 8u);
  for (const int threads : {2, 7}) {
    const auto several = build_partial_tree(set.input(), {.threads = threads});
    ASSERT_TRUE(several.ok());
    test::expect_same(several->tree, one->tree);
    ASSERT_EQ(several->deferred.size(), one->deferred.size());
    for (std::size_t i = 0; i < one->deferred.size(); ++i) {
      const auto boxes = [](const DeferredLeaf& leaf) {
        std::vector<Aabb> all;
        for (const ObjectPart& part : leaf.parts) all.push_back(part.box);
        return all;
      };
      EXPECT_EQ(boxes(several->deferred[i]), boxes(one->deferred[i]));
    }
  }
}

TEST(PartialTree, WhatIsPutOffIsBuiltFromThereOn) {
  const BoxSet set = test::random_boxes(many, 9);
  const auto whole = build_partial_tree(set.input(), {.leaf_size = 4});
  ASSERT_TRUE(whole.ok());
  for (const DeferredLeaf& leaf : whole->deferred) {
    const auto part = build_deferred(set.input(), whole->tree, leaf, std::size_t{1} << 30);
    ASSERT_TRUE(part.ok());
    EXPECT_FALSE(part->tree.nodes[0].is_leaf());
    EXPECT_EQ(part->tree.box, leaf.place.cell);
    std::vector<std::uint32_t> found(part->tree.references.begin(), part->tree.references.end());
    std::ranges::sort(found);
    found.erase(std::ranges::unique(found).begin(), found.end());
    EXPECT_TRUE(std::ranges::equal(found, leaf.parts, {}, {}, &ObjectPart::object));
    expect_deferred(*part, 4);
  }
}

TEST(PartialTree, LimitsHoldForUpperParts) {
  const BoxSet set = test::random_boxes(many, 3);
  const auto shallow = build_partial_tree(set.input(), {.max_depth = 2});
  ASSERT_TRUE(shallow.ok());
  EXPECT_LE(shallow->tree.nodes.size(), 7u);
  EXPECT_TRUE(shallow->deferred.empty());
  const std::size_t limit = shallow->tree.bytes();
  const auto small = build_partial_tree(set.input(), {.memory_limit = limit});
  ASSERT_TRUE(small.ok());
  EXPECT_TRUE(small->tree.memory_limit_reached);
  EXPECT_LE(small->tree.bytes(), limit);
}

TEST(PartialTree, AStopEndsUpperParts) {
  const BoxSet set = test::random_boxes(many, 2);
  std::stop_source source;
  source.request_stop();
  const auto stopped = build_partial_tree(set.input(), {}, source.get_token());
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().message, "stopped");
}

}  // namespace
}  // namespace bspview
