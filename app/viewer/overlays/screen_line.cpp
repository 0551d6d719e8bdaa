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

/// Least depth of what is drawn, for coordinates to be exact to a fraction of a pixel.
double nearest_depth(const Segment& segment) {
  return 1e-9 * std::max(std::abs(segment.from.z), std::abs(segment.to.z));
}

/// Signed distances (any positive scale) from the borders and the eye's plane; >= 0 is inside.
struct Borders {
  double width, height, margin, nearest;

  std::array<double, 5> inside_distances(Vec3d point) const {
    return {point.x + margin * point.z, (width + margin) * point.z - point.x,
            point.y + margin * point.z, (height + margin) * point.z - point.y, point.z - nearest};
  }
};

bool is_finite(Vec3 v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::optional<Segment> clip(const Segment& segment, const Borders& borders) {
  const auto at_from = borders.inside_distances(segment.from);
  const auto at_to = borders.inside_distances(segment.to);
  double enter = 0.0, leave = 1.0;
  for (std::size_t i = 0; i < at_from.size(); ++i) {
    if (at_from[i] >= 0.0 && at_to[i] >= 0.0) continue;
    if (at_from[i] < 0.0 && at_to[i] < 0.0) return {};
    const double crossing = at_from[i] / (at_from[i] - at_to[i]);
    (at_from[i] < 0.0 ? enter : leave) =
        at_from[i] < 0.0 ? std::max(enter, crossing) : std::min(leave, crossing);
  }
  if (enter > leave) return {};
  const Vec3d along = segment.to - segment.from;
  return Segment{segment.from + enter * along, segment.from + leave * along};
}

/// (x, y, 1 / depth) in pixels.
Vec3 to_pixels(Vec3d point) {
  const double inverse = 1.0 / point.z;
  return Vec3(point.x * inverse, point.y * inverse, inverse);
}

}  // namespace

std::optional<ScreenLine> project_line(const ScreenTransform& transform, const Line& line) {
  const Vec3 from = transform.homogeneous(line.from), to = transform.homogeneous(line.to);
  if (!is_finite(from) || !is_finite(to)) return {};
  const Segment segment{from, to};
  const auto inside = clip(segment, {double(transform.width()), double(transform.height()),
                                     line.width, nearest_depth(segment)});
  if (!inside) return {};
  Vec3 a = to_pixels(inside->from), b = to_pixels(inside->to);

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
  result.inverse_depth = a.z;
  result.inverse_depth_slope = (b.z - a.z) / length;
  result.half_thickness = 0.5f * line.width * std::sqrt(1.0f + result.slope * result.slope);
  return result;
}

}  // namespace bspview
