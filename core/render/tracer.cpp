#include "core/render/tracer.h"

namespace bspview {

PathRay& PathTracer::start(const Ray& ray, RayKind kind, int level) {
  last_at_level_.resize(static_cast<std::size_t>(level) + 1, -1);
  PathRay path;
  path.kind = kind;
  path.level = level;
  path.parent = last_at_level_[static_cast<std::size_t>(level) - 1];
  path.ray = ray;
  rays_.push_back(path);
  return rays_.back();
}

Hit PathTracer::closest(const Ray& ray, RayKind kind, int level) {
  PathRay& path = start(ray, kind, level);
  LogObserver log(path.log);
  const Hit hit = trace_closest(world_, ray, rules_, log);
  path.object = hit.object;
  path.t = hit.t;
  last_at_level_[static_cast<std::size_t>(level)] = static_cast<int>(rays_.size()) - 1;
  return hit;
}

bool PathTracer::occluded(const Ray& ray, int level) {
  PathRay& path = start(ray, RayKind::shadow, level + 1);
  LogObserver log(path.log);
  path.object = trace_any(world_, ray, rules_, log);
  if (path.object != no_index) path.t = path.log.tests.back().t;
  return path.object != no_index;
}

double ReferenceTracer::hit(std::uint32_t id, const RayQuery& ray, SideRule sides) const {
  const Object& object = scene_.objects[id];
  if (object.kind != ObjectKind::triangle) return hit_object(scene_, id, ray, sides);
  const Face& face = scene_.faces[object.shape];
  return hit_triangle_double(ray, &scene_.vertices[face.first_vertex],
                             visible_sides(scene_, object, sides));
}

Hit ReferenceTracer::closest(const Ray& ray, RayKind, int) {
  const RayQuery query(ray);
  Hit best;
  for (std::uint32_t id = 0; id < scene_.objects.size(); ++id) {
    const double t = hit(id, query, rules_.sides);
    if (t < best.t) best = {t, id, no_leaf};
  }
  return best;
}

bool ReferenceTracer::occluded(const Ray& ray, int) {
  const RayQuery query(ray);
  for (std::uint32_t id = 0; id < scene_.objects.size(); ++id) {
    if (hit(id, query, rules_.shadow_sides) != no_hit) return true;
  }
  return false;
}

}  // namespace bspview
