// Clipping after Liang & Barsky 1984, "A new concept and method for line clipping", in homogeneous
// coordinates.
#include "app/viewer/overlays/screen_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace bspview {
namespace {

struct Segment {
  Vec3d from, to;  // homogeneous pixel coordinates
};

/// Borders of the picture, moved outwards; homogeneous pixel coordinates.
struct Borders {
  double left, top, right, bottom;
  double nearest;  ///< depth

  /// Signed distances (any positive scale) from borders and nearest depth; >= 0 is inside.
  std::array<double, 5> inside_distances(Vec3d point) const {
    return {point.x - left * point.z, right * point.z - point.x, point.y - top * point.z,
            bottom * point.z - point.y, point.z - nearest};
  }
};

std::optional<Segment> clip(const Segment& segment, const Borders& borders) {
  const auto at_from = borders.inside_distances(segment.from);
  const auto at_to = borders.inside_distances(segment.to);
  double enter = 0.0, leave = 1.0;
  for (std::size_t i = 0; i < at_from.size(); ++i) {
    if (at_from[i] >= 0.0 && at_to[i] >= 0.0) continue;
    if (at_from[i] < 0.0 && at_to[i] < 0.0) return {};
    const double crossing = at_from[i] / (at_from[i] - at_to[i]);
    if (at_from[i] < 0.0) {
      enter = std::max(enter, crossing);
    } else {
      leave = std::min(leave, crossing);
    }
  }
  if (enter > leave) return {};
  const Vec3d along = segment.to - segment.from;
  return Segment{segment.from + enter * along, segment.from + leave * along};
}

bool is_finite(Vec3 v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// A line's end in pixels.
struct End {
  float x, y, inverse_depth;
};

End to_pixels(Vec3 point) {
  const float inverse = 1.0f / point.z;
  return {point.x * inverse, point.y * inverse, inverse};
}

End to_pixels(Vec3d point) {
  const double inverse = 1.0 / point.z;
  return {static_cast<float>(point.x * inverse), static_cast<float>(point.y * inverse),
          static_cast<float>(inverse)};
}

bool is_inside(const ScreenTransform& transform, Vec3 point) {
  return point.z > 0.0f && point.x >= 0.0f && point.y >= 0.0f &&
         point.x <= static_cast<float>(transform.width()) * point.z &&
         point.y <= static_cast<float>(transform.height()) * point.z;
}

struct Ends {
  End from, to;
};

std::optional<Ends> find_ends(const ScreenTransform& transform, const Line& line) {
  const Vec3 from = transform.homogeneous(line.from), to = transform.homogeneous(line.to);
  if (is_inside(transform, from) && is_inside(transform, to)) {
    return Ends{to_pixels(from), to_pixels(to)};
  }
  if (!is_finite(from) || !is_finite(to)) return {};
  // Nearer to the eye, differences of the ends' coordinates would not be exact to a pixel.
  const double nearest = 1e-9 * std::max(std::abs(from.z), std::abs(to.z));
  const double margin = max_line_width;
  const auto inside = clip({from, to}, {-margin, -margin, transform.width() + margin,
                                        transform.height() + margin, nearest});
  if (!inside) return {};
  return Ends{to_pixels(inside->from), to_pixels(inside->to)};
}

}  // namespace

std::optional<ScreenLine> project_line(const ScreenTransform& transform, const Line& line) {
  const auto ends = find_ends(transform, line);
  if (!ends || !(line.width > 0.0f)) return {};
  auto [a, b] = *ends;
  ScreenLine result;
  result.color = line.color;
  result.steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
  if (result.steep) {
    std::swap(a.x, a.y);
    std::swap(b.x, b.y);
  }
  if (a.x > b.x) std::swap(a, b);
  const float length = b.x - a.x;
  if (!(length > 0.0f)) return {};
  result.first = a.x;
  result.last = b.x;
  result.minor = a.y;
  result.slope = (b.y - a.y) / length;
  result.inverse_depth = a.inverse_depth;
  result.inverse_depth_slope = (b.inverse_depth - a.inverse_depth) / length;
  result.half_thickness =
      0.5f * std::min(line.width, max_line_width) * std::sqrt(1.0f + result.slope * result.slope);
  return result;
}

}  // namespace bspview
