#include "core/render/tracer.h"

namespace bspview {
namespace {

std::uint32_t leaves_of(const RayCost& cost) {
  return static_cast<std::uint32_t>(cost.leaves);
}

}  // namespace

void RecordTracer::closest(std::span<const Ray> rays, std::span<const RayRole> roles,
                           std::span<Hit> hits) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    RayCost cost;
    CountObserver count(cost);
    hits[i] = trace_closest(world_, rays[i], rules_, count);
    const float end = hits[i] ? static_cast<float>(hits[i].t) : rays[i].t_max;
    rays_.push_back({rays[i], leaves_of(cost), end, roles[i].kind, i == 0});
  }
}

void RecordTracer::occluded(std::span<const Ray> rays, std::span<const RayRole> roles,
                            std::span<char> blocked) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    RayCost cost;
    CountObserver count(cost);
    const Ray& ray = rays[i];
    const std::uint32_t blocker = trace_any(world_, ray, rules_, count);
    blocked[i] = blocker != no_index;
    float end = ray.t_max;
    if (blocked[i]) {
      const RayQuery query = ExactShapes::query(world_, ray);
      end = static_cast<float>(hit_object(world_.scene, blocker, query, rules_.shadow_sides));
    }
    rays_.push_back({ray, leaves_of(cost), end, roles[i].kind, i == 0});
  }
}

PathRay& PathOne::start(const Ray& ray, const RayRole& role) {
  PathRay path;
  path.kind = role.kind;
  path.level = role.level;
  path.parent = role.sender < 0 ? -1 : index_of_[static_cast<std::size_t>(role.sender)];
  path.ray = ray;
  rays_.push_back(path);
  return rays_.back();
}

Hit PathOne::closest(const Ray& ray, const RayRole& role) {
  PathRay& path = start(ray, role);
  LogObserver log(path.log);
  const Hit hit = trace_closest(world_, ray, rules_, log);
  path.object = hit.object;
  path.t = hit.t;
  const auto number = static_cast<std::size_t>(role.number);
  if (index_of_.size() <= number) index_of_.resize(number + 1);
  index_of_[number] = static_cast<int>(rays_.size()) - 1;
  return hit;
}

bool PathOne::occluded(const Ray& ray, const RayRole& role) {
  PathRay& path = start(ray, role);
  LogObserver log(path.log);
  path.object = trace_any(world_, ray, rules_, log);
  if (path.object != no_index) path.t = path.log.tests.back().t;
  return path.object != no_index;
}

double ReferenceOne::hit(std::uint32_t id, const RayQuery& ray, SideRule sides) const {
  const Object& object = scene_.objects[id];
  if (object.kind != ObjectKind::triangle) return hit_object(scene_, id, ray, sides);
  const Face& face = scene_.faces[object.shape];
  return hit_triangle_double(ray, &scene_.vertices[face.first_vertex],
                             visible_sides(scene_, object, sides));
}

Hit ReferenceOne::closest(const Ray& ray, const RayRole&) {
  const RayQuery query(ray);
  Hit best;
  for (std::uint32_t id = 0; id < scene_.objects.size(); ++id) {
    const double t = hit(id, query, rules_.sides);
    if (t < best.t) best = {t, id, no_leaf};
  }
  return best;
}

bool ReferenceOne::occluded(const Ray& ray, const RayRole&) {
  const RayQuery query(ray);
  for (std::uint32_t id = 0; id < scene_.objects.size(); ++id) {
    if (hit(id, query, rules_.shadow_sides) != no_hit) return true;
  }
  return false;
}

}  // namespace bspview
