#include "core/render/accelerator.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/render/scene_tree.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

struct Built {
  Built(const Scene& the_scene, const BuildParams& params)
      : scene(the_scene),
        tree(*build_scene_tree(scene, params)),
        accelerator(make_accelerator({scene, tree})) {}

  /// Calls visit(leaf) for every leaf, in the order of the nodes.
  void visit_leaves(const auto& visit) const {
    for (const WideNode& node : accelerator->tree().nodes) {
      for (int slot = 0; slot < WideNode::width; ++slot) {
        const bool is_used = node.bounds[0][slot] <= node.bounds[1][slot];
        if (is_used && (node.child[slot] & WideNode::leaf_bit)) {
          visit(accelerator->leaf(node.child[slot]));
        }
      }
    }
  }

  std::vector<TriangleBlock> blocks() const {
    std::vector<TriangleBlock> list;
    visit_leaves([&](const WideLeaf& leaf) {
      const auto blocks = accelerator->blocks(leaf);
      list.insert(list.end(), blocks.begin(), blocks.end());
    });
    return list;
  }
  std::vector<LeafObject> others() const {
    std::vector<LeafObject> list;
    visit_leaves([&](const WideLeaf& leaf) {
      list.insert(list.end(), accelerator->others(leaf).begin(), accelerator->others(leaf).end());
    });
    return list;
  }

  Scene scene;
  Tree tree;
  std::shared_ptr<const Accelerator> accelerator;
};

std::vector<Scene> scenes() {
  return {test::random_scene(3000, 1), test::random_triangles(20000, 2), Scene{}};
}

TEST(Accelerator, IsTheSameForAnyNumberOfThreads) {
  for (const Scene& scene : scenes()) {
    const Built first(scene, {.threads = 1});
    const std::vector<TriangleBlock> blocks = first.blocks();
    const std::vector<LeafObject> others = first.others();
    for (const int threads : {2, 3, 8}) {
      const Built again(scene, {.threads = threads});
      const auto same = [](const auto& a, const auto& b) {
        return a.size() == b.size() &&
               std::ranges::equal(std::as_bytes(std::span(a)), std::as_bytes(std::span(b)));
      };
      EXPECT_TRUE(same(first.accelerator->tree().nodes, again.accelerator->tree().nodes));
      EXPECT_TRUE(same(blocks, again.blocks()));
      EXPECT_TRUE(same(others, again.others()));
    }
  }
}

TEST(Accelerator, HoldsEveryObjectThatIsNotDegenerate) {
  for (const Scene& scene : scenes()) {
    const Built built(scene, {});
    std::vector<char> is_there(scene.objects.size());
    for (const TriangleBlock& block : built.blocks()) {
      for (const std::uint32_t id : block.object) {
        if (id != no_index) is_there[id] = 1;
      }
    }
    for (const LeafObject& object : built.others()) is_there[object.id] = 1;
    for (std::uint32_t id = 0; id < scene.objects.size(); ++id) {
      EXPECT_EQ(is_there[id] != 0, !is_degenerate(scene, id)) << "object " << id;
    }
  }
}

TEST(Accelerator, LeavesOfTrianglesOnlyFillTheirBlocks) {
  const Built built(test::random_triangles(20000, 3), {});
  std::size_t slots = 0, used = 0;
  built.visit_leaves([&](const WideLeaf& leaf) {
    ASSERT_EQ(leaf.other_count, 0u);
    ASSERT_GE(leaf.block_count, 1u);
    for (const TriangleBlock& block : built.accelerator->blocks(leaf)) {
      slots += TriangleBlock::width;
      used += static_cast<std::size_t>(TriangleBlock::width -
                                       std::ranges::count(block.object, no_index));
    }
  });
  EXPECT_GT(2 * used, slots);
}

TEST(Accelerator, IsNotMadeOnceAStopIsRequested) {
  const Built built(test::random_scene(500, 4), {});
  std::stop_source stopper;
  stopper.request_stop();
  EXPECT_FALSE(make_accelerator({built.scene, built.tree}, stopper.get_token()));
}

}  // namespace
}  // namespace bspview
