#include "core/eval/stress/brute.h"

#include <algorithm>

namespace bspview::stress {
namespace {

constexpr std::uint32_t group_size = 4;

/// 2^-16 of the largest coordinate on every side: shape tests are off by less than 2^-40 of it.
constexpr double widening = 0x1p-16;

double largest_magnitude(Vec3 v) {
  return largest_component(magnitudes(v));
}

/// Where `ray` surely has not yet entered `box`, widened; no_hit when it passes it by.
double enters(const Aabb& box, const Ray& ray) {
  const double margin = widening * std::max({largest_magnitude(box.lo), largest_magnitude(box.hi),
                                             largest_magnitude(ray.origin)});
  double enter = ray.t_min, exit = ray.t_max;
  for (int axis = 0; axis < 3; ++axis) {
    const double below = double{box.lo[axis]} - ray.origin[axis] - margin;
    const double above = double{box.hi[axis]} - ray.origin[axis] + margin;
    const double d = ray.direction[axis];
    if (d == 0.0) {
      if (below > 0.0 || above < 0.0) return no_hit;
      continue;
    }
    enter = std::max(enter, std::min(below / d, above / d));
    exit = std::min(exit, std::max(below / d, above / d));
  }
  return enter <= exit ? enter : no_hit;
}

bool is_ray(const Ray& ray) {
  const Vec3 zero = 0.0f * (ray.origin + ray.direction);
  return zero == Vec3(0.0f) && ray.direction != Vec3(0.0f) && ray.t_min < ray.t_max;
}

}  // namespace

BruteForce::BruteForce(const Scene& scene) : scene_(scene) {
  const std::vector<Aabb> boxes = object_bounds(scene);
  for (std::uint32_t id = 0; id < boxes.size(); ++id) {
    if (boxes[id].empty() || is_degenerate(scene, id)) continue;
    objects_.push_back(id);
    bounds_.grow(boxes[id]);
  }
  if (!objects_.empty()) group(0, static_cast<std::uint32_t>(objects_.size()), boxes);
}

void BruteForce::group(std::uint32_t first, std::uint32_t count, const std::vector<Aabb>& boxes) {
  const auto ids = objects_.begin() + first;
  const std::size_t index = groups_.size();
  groups_.push_back({Aabb{}, first, count});
  for (std::uint32_t i = 0; i < count; ++i) groups_[index].box.grow(boxes[ids[i]]);
  if (count <= group_size) return;
  const Vec3 extent = groups_[index].box.extent();
  const int axis = extent.x >= std::max(extent.y, extent.z) ? 0 : extent.y >= extent.z ? 1 : 2;
  const std::uint32_t half = count / 2;
  std::nth_element(ids, ids + half, ids + count, [&](std::uint32_t a, std::uint32_t b) {
    return boxes[a].lo[axis] < boxes[b].lo[axis];
  });
  group(first, half, boxes);
  groups_[index].first = static_cast<std::uint32_t>(groups_.size());
  groups_[index].count = 0;
  group(first + half, count - half, boxes);
}

Hit BruteForce::closest(const Ray& ray) const {
  Hit best;
  if (objects_.empty() || !is_ray(ray)) return best;
  const RayQuery query(ray, reach_of(bounds_, ray.origin));
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const std::uint32_t index = open.back();
    const Group& node = groups_[index];
    open.pop_back();
    // A tie must not be cut off: what is entered behind the best hit is.
    if (enters(node.box, ray) > best.t || enters(node.box, ray) == no_hit) continue;
    if (node.count == 0) {
      open.insert(open.end(), {node.first, index + 1});
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const std::uint32_t id = objects_[i];
      const double t = hit_object(scene_, id, query, SideRule::two_sided);
      if (t == no_hit) continue;
      if (t < best.t || (t == best.t && id < best.object)) best = {t, id, no_leaf};
    }
  }
  return best;
}

}  // namespace bspview::stress
