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
#include <limits>

#include "core/bsp/ray_walk.h"
#include "core/bsp/wide_tree.h"
#include "core/math/mask_bits-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The cells of a node, or as many of them as a vector holds.
using CellTag = hn::CappedTag<float, WideNode::width>;
using CellV = hn::Vec<CellTag>;
inline constexpr CellTag cell_tag;

/// Relative to a plane's distance: how much later than computed a ray may leave a cell that it
/// enters sooner. Both distances are off by plane_error / 2, and the later one once more by this.
inline constexpr float passing = 1.0f + 2.0f * plane_error;

/// Relative to the distance of the best hit: cells that are entered behind it are of no use. Cells
/// overlap by their borders, and polygons off their plane are met too soon (longest_passage).
inline constexpr float hit_margin = 1.0f + 16.0f * plane_error;

/// What the walk needs of a ray: t_min >= 0, a finite origin, a direction of a size near 1.
struct WideRay {
  WideRay() = default;
  HWY_INLINE explicit WideRay(const Ray& ray)
      : origin(ray.origin), inverse(1.0f / ray.direction), t_min(ray.t_min) {
    for (int axis = 0; axis < 3; ++axis) {
      near_row[axis] =
          2 * axis + static_cast<int>(std::bit_cast<std::uint32_t>(inverse[axis]) >> 31);
    }
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
    const auto distance = [&](int row, int axis, float inverse) {
      const CellV plane = hn::Load(cell_tag, node.bounds[row] + i);
      return hn::Mul(hn::Sub(plane, hn::Set(cell_tag, ray.origin[axis])),
                     hn::Set(cell_tag, inverse));
    };
    const auto near = [&](int axis) {
      return distance(ray.near_row[axis], axis, ray.inverse[axis]);
    };
    const auto far = [&](int axis) {
      return distance(ray.near_row[axis] ^ 1, axis, ray.inverse[axis] * passing);
    };
    // A ray that lies in a plane is on its right side: Max and Min answer what is no NaN if it is
    // their second operand (x86), or any (others).
    const CellV start = hn::Set(cell_tag, ray.t_min), end = hn::Set(cell_tag, reach);
    const CellV first = hn::Max(near(0), hn::Max(near(1), hn::Max(near(2), start)));
    const CellV last = hn::Min(far(0), hn::Min(far(1), hn::Min(far(2), end)));
    hn::Store(first, cell_tag, enter + i);
    found |= bits_of(cell_tag, hn::Le(first, last)) << i;
  }
  return found;
}

/// Cells still to visit, the next one on top. Every level of the tree leaves all but one.
class WideStack {
 public:
  /// Below all cells: a leaf that is none.
  static constexpr std::uint32_t bottom = 0xffffffffu;

  WideStack() : top_(entries_) { *top_++ = entry(-std::numeric_limits<float>::infinity(), bottom); }
  WideStack(const WideStack&) = delete;
  WideStack& operator=(const WideStack&) = delete;

  /// A child and where the ray enters it. Distances are not negative: entries sort like integers.
  static std::uint64_t entry(float enter, std::uint32_t child) {
    return std::uint64_t{std::bit_cast<std::uint32_t>(enter)} << 32 | child;
  }
  static std::uint32_t child(std::uint64_t entry) { return static_cast<std::uint32_t>(entry); }
  static float enter(std::uint64_t entry) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(entry >> 32));
  }

  std::uint64_t pop() { return *--top_; }

  /// The next one that is entered before `reach`, or bottom.
  HWY_INLINE std::uint32_t pop_child(float reach) {
    std::uint64_t next = pop();
    while (!(enter(next) <= reach)) next = pop();
    return child(next);
  }

  /// Pushes an entry if `is_wanted`, without a branch.
  HWY_INLINE void push_if(bool is_wanted, std::uint64_t entry) {
    *top_ = entry;
    top_ += is_wanted;
  }

  /// Puts the cells of one node there as they come, the last on top; name(slot) answers the child.
  template <class Name>
  HWY_INLINE void push_all(unsigned slots, const float* enter, Name name) {
    for (; slots != 0; slots &= slots - 1) {
      const int slot = __builtin_ctz(slots);
      *top_++ = entry(enter[slot], name(slot));
    }
  }

  /// The same, each at its place among the others, the nearest on top.
  template <class Name>
  HWY_INLINE void push_sorted(unsigned slots, const float* enter, Name name) {
    std::uint64_t* const base = top_;
    for (; slots != 0; slots &= slots - 1) {
      const int slot = __builtin_ctz(slots);
      const std::uint64_t next = entry(enter[slot], name(slot));
      std::uint64_t* place = top_++;
      for (; place > base && place[-1] < next; --place) *place = place[-1];
      *place = next;
    }
  }

 private:
  // Not initialized; one more than is ever used, for push_if.
  std::uint64_t entries_[(WideNode::width - 1) * (WideTree::most_levels + 1) + 3];
  std::uint64_t* top_;
};

/// The nearest of the cells that a ray passes, at least one; the others go onto the stack.
HWY_INLINE std::uint32_t take_nearest(const WideNode& node, unsigned slots, const float* enter,
                                      WideStack& stack) {
  const auto entry_of = [&](unsigned among) {
    const int slot = __builtin_ctz(among);
    return WideStack::entry(enter[slot], node.child[slot]);
  };
  const unsigned others = slots & (slots - 1);
  if ((others & (others - 1)) != 0) {
    stack.push_sorted(slots, enter, [&](int slot) { return node.child[slot]; });
    return WideStack::child(stack.pop());
  }
  // One or two, which no predictor can tell: where there is no second, one behind everything.
  const std::uint64_t none = -std::uint64_t{others == 0};
  const std::uint64_t a = entry_of(slots);
  const std::uint64_t b = entry_of(others | 1u << (WideNode::width - 1)) | none;
  stack.push_if(others != 0, std::max(a, b));
  return WideStack::child(std::min(a, b));
}

/// Goes from a node down to the nearest leaf that the ray passes before `reach`, or to the next one
/// on the stack.
HWY_INLINE std::uint32_t go_down(const WideTree& tree, const WideRay& ray, float reach,
                                 std::uint32_t child, WideStack& stack) {
  while (!(child & WideNode::leaf_bit)) {
    const WideNode& node = tree.nodes[child];
    alignas(64) float enter[WideNode::width];
    const unsigned slots = find_cells(node, ray, reach, enter);
    child = slots != 0 ? take_nearest(node, slots, enter, stack) : stack.pop_child(reach);
  }
  return child;
}

/// Visits the leaves along the ray below a node, nearest first; leaf(child) tests the objects and
/// may make `reach` less, below 0 to end the walk.
template <class Leaf>
HWY_INLINE void traverse_wide_from(const WideTree& tree, const WideRay& ray, const float& reach,
                                   std::uint32_t child, Leaf&& leaf) {
  WideStack stack;
  for (;;) {
    child = go_down(tree, ray, reach, child, stack);
    if (child == WideStack::bottom) return;
    leaf(child);
    child = stack.pop_child(reach);
  }
}

template <class Leaf>
HWY_INLINE void traverse_wide(const WideTree& tree, const WideRay& ray, const float& reach,
                              Leaf&& leaf) {
  traverse_wide_from(tree, ray, reach, 0, leaf);
}

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
