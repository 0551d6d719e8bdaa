#pragma once

#include <bit>
#include <cstdint>

#include "core/base/raw_vector.h"

namespace bspview {

/// One node of a BSP tree in 8 bytes:
///
///             word 0                          word 1
///     inner   left child << 2 | axis (0..2)   split plane, the bits of a float
///     leaf    object count << 2 | 3           index of its first reference
///
/// The right child follows the left one.
class Node {
 public:
  static Node make_inner(int axis, float split, std::uint32_t left) {
    return Node(left << 2 | static_cast<std::uint32_t>(axis), std::bit_cast<std::uint32_t>(split));
  }
  static Node make_leaf(std::uint32_t first_reference, std::uint32_t count) {
    return Node(count << 2 | 3u, first_reference);
  }

  bool is_leaf() const { return (word0_ & 3u) == 3u; }

  int axis() const { return static_cast<int>(word0_ & 3u); }
  float split() const { return std::bit_cast<float>(word1_); }
  std::uint32_t left() const { return word0_ >> 2; }
  std::uint32_t right() const { return left() + 1; }

  std::uint32_t count() const { return word0_ >> 2; }
  std::uint32_t first_reference() const { return word1_; }

  bool operator==(const Node&) const = default;

 private:
  Node(std::uint32_t word0, std::uint32_t word1) : word0_(word0), word1_(word1) {}
  std::uint32_t word0_, word1_;
};
static_assert(sizeof(Node) == 8);

using Nodes = RawVector<Node>;
using References = RawVector<std::uint32_t>;  ///< object ids

/// Index of the leaf that is not there.
inline constexpr std::uint32_t no_leaf = 0xffffffffu;

}  // namespace bspview
