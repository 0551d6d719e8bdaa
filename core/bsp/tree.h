#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/bsp/node.h"
#include "core/math/aabb.h"

namespace bspview {

/// How the split planes are chosen. Sources at the split_<rule>.cpp files.
enum class Builder { naive, median, median_longest, object_median, mb, sah, sah_binned };

/// Names as on the command line, in the order of the enumerators.
std::span<const std::string_view> builder_names();
std::string_view name_of(Builder builder);

/// What a tree is built with; compares by value.
struct BuildParams {
  Builder builder = Builder::sah;
  std::optional<int> max_depth;  ///< nullopt: automatic_depth(number of objects)
  int leaf_size = 1;             ///< leaf when a node holds at most as many objects
  std::optional<bool> clip;      ///< nullopt: off for median, on for the others
  float cost_traversal = 1.0f;
  std::optional<float> cost_intersection;  ///< nullopt: what testing the objects costs
  float empty_bonus = 0.1f;      ///< share of the tests that a plane with an empty side is spared
  std::size_t memory_limit = std::size_t{1} << 30;  ///< bytes of nodes and references
  int threads = 0;               ///< 0: every core; never changes the tree
  bool lazy = false;             ///< built where rays go (core/render/lazy_tree.h)

  bool operator==(const BuildParams&) const = default;
};

inline constexpr int depth_cap = 64;  ///< no tree is deeper; traversal stacks hold depth_cap + 2

int automatic_depth(std::size_t objects);  ///< round(8 + 1.3 log2 N), as pbrt
int effective_depth(const BuildParams& params, std::size_t objects);
bool effective_clip(const BuildParams& params);

/// A finished tree. nodes[0] is the root; parents come before their children.
struct Tree {
  Aabb box;                               ///< of the root; holds every object
  Nodes nodes;
  References references;                  ///< object ids, leaf after leaf
  std::vector<std::uint32_t> unbuilt;     ///< leaves that are yet to be split; ascending
  std::size_t object_count = 0;
  BuildParams params;                     ///< as asked for
  int max_depth = 0;                      ///< in force
  float cost_intersection = 0.0f;         ///< in force; the mean over the objects
  bool naive = false;                     ///< one leaf that every ray visits, even beside the box
  bool memory_limit_reached = false;      ///< some nodes became leaves for that reason alone
  double build_seconds = 0.0;

  std::span<const std::uint32_t> objects_of(const Node& leaf) const {
    return std::span(references).subspan(leaf.first_reference(), leaf.count());
  }
  std::size_t bytes() const {
    return nodes.size() * sizeof(Node) + references.size() * sizeof(std::uint32_t);
  }
};

/// The two cells that a plane makes of `cell`; both hold the plane itself.
struct Cells {
  Aabb left, right;
};
inline Cells split_cell(const Aabb& cell, int axis, float split) {
  Cells cells{cell, cell};
  cells.left.hi[axis] = split;
  cells.right.lo[axis] = split;
  return cells;
}

}  // namespace bspview
