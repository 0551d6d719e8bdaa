// Traversal of a wide tree by one ray. Included once for every instruction set that Highway
// (hwy/foreach_target.h) compiles for.

#if defined(BSPVIEW_TRAVERSE_WIDE) == defined(HWY_TARGET_TOGGLE)
#ifdef BSPVIEW_TRAVERSE_WIDE
#undef BSPVIEW_TRAVERSE_WIDE
#else
#define BSPVIEW_TRAVERSE_WIDE
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>

#include "core/bsp/ray_walk.h"
#include "core/bsp/wide_tree.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The cells of a node, or as many of them as a vector holds.
using CellTag = hn::CappedTag<float, WideNode::width>;
using CellV = hn::Vec<CellTag>;
inline constexpr CellTag cell_tag;

/// Relative to a plane's distance: how much later than computed a ray may leave a cell that it
/// enters sooner. Both distances are off by plane_error / 2.
inline constexpr float passing = 1.0f + 2.0f * plane_error;

/// Relative to the distance of the best hit: cells that are entered behind it are of no use. Cells
/// overlap by their borders, and polygons off their plane are met too soon (longest_passage).
inline constexpr float hit_margin = 1.0f + 16.0f * plane_error;

/// What the walk needs of a ray: t_min >= 0, a finite origin, a direction of a size near 1.
struct WideRay {
  explicit WideRay(const Ray& ray)
      : origin(ray.origin), inverse(1.0f / ray.direction), t_min(ray.t_min) {
    for (int axis = 0; axis < 3; ++axis) near_row[axis] = 2 * axis + (inverse[axis] < 0.0f ? 1 : 0);
  }

  Vec3 origin;
  Vec3 inverse;  ///< infinite for a component of 0: planes are at +-inf, those it lies in at NaN
  float t_min;
  int near_row[3];  ///< of WideNode::bounds; the far one is its neighbour
};

/// The slots whose cells the ray passes before `reach`, a bit each; enter[slot]: where.
HWY_INLINE unsigned find_cells(const WideNode& node, const WideRay& ray, float reach,
                               float* enter) {
  unsigned found = 0;
  for (std::size_t i = 0; i < WideNode::width; i += hn::Lanes(cell_tag)) {
    const auto distance = [&](int row, int axis) {
      const CellV plane = hn::Load(cell_tag, node.bounds[row] + i);
      return hn::Mul(hn::Sub(plane, hn::Set(cell_tag, ray.origin[axis])),
                     hn::Set(cell_tag, ray.inverse[axis]));
    };
    const auto near = [&](int axis) { return distance(ray.near_row[axis], axis); };
    const auto far = [&](int axis) { return distance(ray.near_row[axis] ^ 1, axis); };
    // A ray that lies in a plane is on its right side: Max and Min answer what is no NaN if it is
    // their second operand (x86), or any (others).
    const CellV start = hn::Set(cell_tag, ray.t_min), end = hn::Set(cell_tag, reach);
    const CellV first = hn::Max(hn::Max(near(0), start), hn::Max(near(1), hn::Max(near(2), start)));
    const CellV last = hn::Min(hn::Min(far(0), end), hn::Min(far(1), hn::Min(far(2), end)));
    hn::Store(first, cell_tag, enter + i);
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(cell_tag, hn::Le(first, hn::Mul(last, hn::Set(cell_tag, passing))), bits);
    found |= static_cast<unsigned>(bits[0]) << i;
  }
  return found;
}

/// Cells still to visit, the nearest on top. Every level of the tree leaves at most seven.
class WideStack {
 public:
  /// A child and where the ray enters it. Distances are not negative: entries sort like integers.
  static std::uint64_t entry(float enter, std::uint32_t child) {
    return std::uint64_t{std::bit_cast<std::uint32_t>(enter)} << 32 | child;
  }
  static std::uint32_t child(std::uint64_t entry) { return static_cast<std::uint32_t>(entry); }
  static float enter(std::uint64_t entry) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(entry >> 32));
  }

  bool empty() const { return size_ == 0; }
  std::uint64_t pop() { return entries_[--size_]; }

  void push(std::uint64_t entry) { entries_[size_++] = entry; }

  /// Puts the cells of one node at their place among each other; name(slot) answers the child.
  template <class Name>
  HWY_INLINE void push_sorted(unsigned slots, const float* enter, Name name) {
    const int base = size_;
    for (; slots != 0; slots &= slots - 1) {
      const int slot = __builtin_ctz(slots);
      const std::uint64_t next = entry(enter[slot], name(slot));
      int place = size_++;
      for (; place > base && entries_[place - 1] < next; --place) {
        entries_[place] = entries_[place - 1];
      }
      entries_[place] = next;
    }
  }

 private:
  std::uint64_t entries_[(WideNode::width - 1) * (depth_cap + 1) + 1];  // not initialized
  int size_ = 0;
};

/// Goes from a node down to the nearest leaf; false where the ray passes none before `reach`.
HWY_INLINE bool go_down(const WideTree& tree, const WideRay& ray, float reach, std::uint32_t& child,
                        WideStack& stack) {
  while (!(child & WideNode::leaf_bit)) {
    const WideNode& node = tree.nodes[child];
    alignas(32) float enter[WideNode::width];
    unsigned slots = find_cells(node, ray, reach, enter);
    if (slots == 0) return false;
    const int first = __builtin_ctz(slots);
    slots &= slots - 1;
    if (slots == 0) {
      child = node.child[first];
      continue;
    }
    const int second = __builtin_ctz(slots);
    slots &= slots - 1;
    if (slots == 0) {
      const std::uint64_t a = WideStack::entry(enter[first], node.child[first]);
      const std::uint64_t b = WideStack::entry(enter[second], node.child[second]);
      child = WideStack::child(std::min(a, b));
      stack.push(std::max(a, b));
      continue;
    }
    stack.push_sorted(slots | 1u << first | 1u << second, enter,
                      [&](int slot) { return node.child[slot]; });
    child = WideStack::child(stack.pop());
  }
  return true;
}

/// Visits the leaves along the ray, nearest first; leaf(child) tests the objects and may make
/// `reach` less, below 0 to end the walk.
template <class Leaf>
HWY_INLINE void traverse_wide(const WideTree& tree, const WideRay& ray, const float& reach,
                              Leaf&& leaf) {
  WideStack stack;
  std::uint32_t child = 0;
  for (;;) {
    if (go_down(tree, ray, reach, child, stack)) leaf(child);
    std::uint64_t next;
    do {
      if (stack.empty()) return;
      next = stack.pop();
    } while (!(WideStack::enter(next) <= reach));
    child = WideStack::child(next);
  }
}

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
