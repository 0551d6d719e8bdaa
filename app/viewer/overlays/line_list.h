#pragma once

#include <cstdint>
#include <vector>

#include "core/math/aabb.h"

namespace bspview {

inline constexpr float max_line_width = 8.0f;  ///< pixels; wider lines are drawn so wide

/// A straight line in world space.
struct Line {
  Vec3 from{0.0f}, to{0.0f};
  std::uint32_t color = 0xffffffffu;  ///< RGBA, red in the lowest byte, not premultiplied
  float width = 1.0f;                 ///< pixels, at most max_line_width
  bool operator==(const Line&) const = default;
};

/// What an overlay hands to whoever draws it; where lines meet, later ones matter more.
using LineList = std::vector<Line>;

/// Calls add(axis, from) for the 12 edges of `box`: each goes from `from` along `axis` to box.hi.
template <class Add>
void for_box_edges(const Aabb& box, const Add& add) {
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int corner = 0; corner < 4; ++corner) {
      Vec3 from = box.lo;
      if (corner & 1) from[u] = box.hi[u];
      if (corner & 2) from[v] = box.hi[v];
      add(axis, from);
    }
  }
}

/// Adds the 12 edges of `box` as lines like `pen` (its colour and width).
inline void add_box(LineList& lines, const Aabb& box, Line pen) {
  for_box_edges(box, [&](int axis, Vec3 from) {
    pen.from = pen.to = from;
    pen.to[axis] = box.hi[axis];
    lines.push_back(pen);
  });
}

}  // namespace bspview
