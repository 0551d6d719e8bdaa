#include "core/shape/triangle.h"

namespace bspview {

ShapeHit hit_triangle_double(const RayQuery& ray, const Vec3* vertices, Sides sides) {
  const Vec3d edge1 = Vec3d(vertices[1]) - Vec3d(vertices[0]);
  const Vec3d edge2 = Vec3d(vertices[2]) - Vec3d(vertices[0]);
  const Vec3d from = Vec3d(ray.origin) - Vec3d(vertices[0]);
  const Vec3d p = glm::cross(Vec3d(ray.direction), edge2);
  const double det = glm::dot(edge1, p);  // > 0: seen from the front
  if (det == 0.0 || (sides == Sides::front && det < 0.0)) return {};
  const Vec3d q = glm::cross(from, edge1);
  const double u = glm::dot(from, p) / det;
  const double v = glm::dot(Vec3d(ray.direction), q) / det;
  if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0)) return {};
  const double t = glm::dot(edge2, q) / det;
  if (!ray.accepts(t)) return {};
  return {t, static_cast<float>(u), static_cast<float>(v)};
}

}  // namespace bspview
