#include "app/viewer/overlays/box_pruning.h"

#include <limits>

namespace bspview {
namespace {

/// One bit for each side of the picture that a homogeneous point lies beyond.
unsigned sides_beyond(Vec3 point, float width, float height) {
  return (point.x < 0.0f ? 1u : 0u) | (point.x > width * point.z ? 2u : 0u) |
         (point.y < 0.0f ? 4u : 0u) | (point.y > height * point.z ? 8u : 0u) |
         (point.z <= 0.0f ? 16u : 0u);
}

}  // namespace

OnScreen find_on_screen(const BoxPruning& pruning, const Aabb& cell) {
  const ScreenTransform& transform = pruning.transform;
  const auto width = static_cast<float>(transform.width());
  const auto height = static_cast<float>(transform.height());
  unsigned beyond_all = ~0u, beyond_any = 0u;
  Vec2 lo(std::numeric_limits<float>::infinity()), hi(-lo);
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner(i & 1 ? cell.hi.x : cell.lo.x, i & 2 ? cell.hi.y : cell.lo.y,
                      i & 4 ? cell.hi.z : cell.lo.z);
    const Vec3 point = transform.homogeneous(corner);
    const unsigned beyond = sides_beyond(point, width, height);
    beyond_all &= beyond;
    beyond_any |= beyond;
    const Vec2 pixel = Vec2(point) / point.z;
    lo = glm::min(lo, pixel);
    hi = glm::max(hi, pixel);
  }
  if (beyond_all != 0) return OnScreen::outside;
  const bool in_front = (beyond_any & 16u) == 0;
  const Vec2 extent = hi - lo;
  const bool small = in_front && extent.x < pruning.min_pixels && extent.y < pruning.min_pixels;
  return small ? OnScreen::small : OnScreen::large;
}

bool is_short(const BoxPruning& pruning, Vec3 from, Vec3 to) {
  const float depth = pruning.transform.homogeneous(0.5f * (from + to)).z;
  const float pixel = depth * pruning.transform.pixel_size();
  return glm::length(to - from) < pruning.min_pixels * pixel;
}

}  // namespace bspview
