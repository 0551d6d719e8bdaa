#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/base/raw_vector.h"
#include "core/bsp/tree.h"

namespace bspview {

/// Finds a node's cell from its index in O(depth), after O(nodes) once. The tree must outlive it.
/// Without use when a stop is requested while it is made.
class NodeCells {
 public:
  explicit NodeCells(const Tree& tree, const std::stop_token& stop = {});

  [[nodiscard]] const Tree& tree() const { return tree_; }
  /// The root's is itself.
  [[nodiscard]] std::uint32_t parent(std::uint32_t node) const { return parents_[node]; }
  [[nodiscard]] Aabb cell(std::uint32_t node) const;
  [[nodiscard]] int depth(std::uint32_t node) const;
  /// Node indices from the root to `node`, both included.
  [[nodiscard]] std::vector<std::uint32_t> path(std::uint32_t node) const;

 private:
  const Tree& tree_;
  RawVector<std::uint32_t> parents_;
};

}  // namespace bspview
