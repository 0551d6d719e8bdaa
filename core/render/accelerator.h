#pragma once

#include <memory>
#include <stop_token>

#include "core/bsp/deferred_leaf.h"
#include "core/bsp/wide_tree.h"
#include "core/render/world.h"
#include "core/shape/triangle_block.h"

namespace bspview {

class LazyPart;

/// An object in a leaf that is no triangle: what its test must know of it, in place.
struct LeafObject {
  std::uint32_t id;
  std::uint32_t shape : 30;
  std::uint32_t kind_number : 2;

  ObjectKind kind() const { return static_cast<ObjectKind>(kind_number); }
  bool operator==(const LeafObject&) const = default;
};

/// A leaf of the wide tree: blocks of triangles, and what else is in it.
struct WideLeaf {
  std::uint32_t first_block = 0, block_count = 0;
  std::uint32_t first_other = 0, other_count = 0;
};

/// Scene and tree laid out for speed: wide nodes, and the triangles of a leaf where the ray needs
/// them. Made from the binary tree in a small part of the time that building that takes; whatever
/// it answers is what the binary tree answers.
class Accelerator {
 public:
  const WideTree& tree() const { return tree_; }
  std::span<const TriangleBlock> blocks(const WideLeaf& leaf) const {
    return {blocks_.data() + leaf.first_block, leaf.block_count};
  }
  std::span<const LeafObject> others(const WideLeaf& leaf) const {
    return std::span(others_).subspan(leaf.first_other, leaf.other_count);
  }
  /// What a child with WideNode::leaf_bit is if it is no leaf but a tree of its own; else null.
  const LazyPart* part(std::uint32_t child) const {
    if ((child & part_bits) != part_bits) [[likely]]
      return nullptr;
    return parts_[child & ~(WideNode::leaf_bit | part_bits)].get();
  }
  std::span<const std::shared_ptr<const LazyPart>> parts() const { return parts_; }
  /// Of any other child with WideNode::leaf_bit.
  WideLeaf leaf(std::uint32_t child) const {
    const std::uint32_t count = child & most_blocks;
    if (!(child & mixed_bit)) return {(child & ~WideNode::leaf_bit) >> count_bits, count, 0, 0};
    if (child & others_bit) return {0, 0, (child & (others_bit - 1)) >> count_bits, count};
    return mixed_[child & (others_bit - 1)];
  }
  /// Of one leaf.
  static constexpr std::uint32_t most_blocks = (1u << 5) - 1u;
  std::size_t bytes() const;  ///< without those of its parts
  double build_seconds() const { return build_seconds_; }

  /// Of a tree whose leaves in tree.unbuilt are `parts`. Nothing soon after a stop is requested.
  static std::shared_ptr<const Accelerator> lay_out(
      const Scene& scene, const Tree& tree, std::vector<std::shared_ptr<const LazyPart>> parts,
      const std::stop_token& stop);

  /// Of the objects of a leaf that is not split, in boxes that overlap; made in no time.
  static Accelerator of_parts(const Scene& scene, std::span<const ObjectPart> parts);

  friend std::shared_ptr<const Accelerator> make_accelerator(const World&, std::stop_token);

 private:
  // The name of a leaf of nothing but triangles, or none, says which; the rest are in the list of
  // mixed ones.
  static constexpr std::uint32_t mixed_bit = 0x40000000u;
  static constexpr std::uint32_t part_bits = mixed_bit | 0x20000000u;
  static constexpr std::uint32_t others_bit = 0x10000000u;  // with mixed_bit
  static constexpr int count_bits = 5;

  class LeafMaker;

  WideTree tree_;
  RawVector<TriangleBlock> blocks_;
  RawVector<LeafObject> others_;
  RawVector<WideLeaf> mixed_;
  std::vector<std::shared_ptr<const LazyPart>> parts_;
  double build_seconds_ = 0.0;
};

/// The world's own accelerator does not matter. Null for naive trees, which are to test every
/// object, soon after a stop is requested, and where memory is short.
std::shared_ptr<const Accelerator> make_accelerator(const World& world, std::stop_token stop = {});

/// A world with an accelerator of its own, where it can have one.
class FastWorld {
 public:
  explicit FastWorld(const World& world)
      : accelerator_(make_accelerator(world)),
        world_{world.scene, world.tree, accelerator_.get()} {}
  const World& world() const { return world_; }

 private:
  std::shared_ptr<const Accelerator> accelerator_;
  World world_;
};

}  // namespace bspview
