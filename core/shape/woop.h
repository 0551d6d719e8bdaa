#pragma once

// After Woop, Benthin & Wald 2013, "Watertight Ray/Triangle Intersection", JCGT 2(1), as published.

#include <algorithm>

#include "core/shape/textbook.h"

namespace bspview {

/// A ray in its own coordinates: the longest axis is z.
struct WoopRay {
  explicit WoopRay(const Ray& ray) : plain(ray) {
    const Vec3 size = magnitudes(ray.direction);
    kz = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    kx = kz == 2 ? 0 : kz + 1;
    ky = kx == 2 ? 0 : kx + 1;
    if (ray.direction[kz] < 0.0f) std::swap(kx, ky);
    shear = {ray.direction[kx] / ray.direction[kz], ray.direction[ky] / ray.direction[kz],
             1.0f / ray.direction[kz]};
  }

  TextbookRay<float> plain;
  int kx, ky, kz;
  Vec3 shear;
};

/// Watertight in itself; edges that float leaves at exactly 0 are decided again in double.
inline double hit_woop(const WoopRay& ray, const Vec3* vertices, Sides sides) {
  const auto seen = [&ray](Vec3 vertex) {
    const Vec3 p = vertex - ray.plain.origin;
    const float z = component(p, ray.kz);
    return Vec3(component(p, ray.kx) - ray.shear.x * z, component(p, ray.ky) - ray.shear.y * z,
                ray.shear.z * z);
  };
  const Vec3 a = seen(vertices[0]), b = seen(vertices[1]), c = seen(vertices[2]);
  float u = c.x * b.y - c.y * b.x, v = a.x * c.y - a.y * c.x, w = b.x * a.y - b.y * a.x;
  if (u == 0.0f || v == 0.0f || w == 0.0f) {
    const auto area = [](Vec3 p, Vec3 q) {
      return static_cast<float>(static_cast<double>(p.x) * q.y - static_cast<double>(p.y) * q.x);
    };
    u = area(c, b);
    v = area(a, c);
    w = area(b, a);
  }
  const float least = std::min({u, v, w}), most = std::max({u, v, w});
  if (least < 0.0f && (most > 0.0f || sides == Sides::front)) return no_hit;
  const float det = u + v + w;
  if (det == 0.0f) return no_hit;
  const float inverse = 1.0f / det;
  const float t = (u * a.z + v * b.z + w * c.z) * inverse;
  if (!ray.plain.accepts(t)) return no_hit;
  return t;
}

}  // namespace bspview
