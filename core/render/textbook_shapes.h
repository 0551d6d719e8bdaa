#pragma once

// Shape tests for closest_hit and any_hit (core/render/intersect.h), put together from a test of
// faces and one of quadrics; each brings what it needs to know of a ray.

#include "core/render/intersect.h"
#include "core/shape/woop.h"

namespace bspview {

/// Moeller & Trumbore, and crossings for polygons.
template <class Real>
struct MoellerFaces {
  using Query = TextbookRay<Real>;
  static Query query(const World&, const Ray& ray) { return Query(ray); }
  static double triangle(const Query& ray, const Vec3* vertices, Sides sides) {
    return hit_moeller_trumbore(ray, vertices, sides);
  }
  static double polygon(const Query& ray, std::span<const Vec3> vertices, const PolygonPlane& plane,
                        Sides sides) {
    return hit_polygon_crossings(ray, vertices, plane, sides);
  }
};

/// Woop, Benthin & Wald, who have no polygons: those by crossings in float.
struct WoopFaces {
  using Query = WoopRay;
  static Query query(const World&, const Ray& ray) { return Query(ray); }
  static double triangle(const Query& ray, const Vec3* vertices, Sides sides) {
    return hit_woop(ray, vertices, sides);
  }
  static double polygon(const Query& ray, std::span<const Vec3> vertices, const PolygonPlane& plane,
                        Sides sides) {
    return hit_polygon_crossings(ray.plain, vertices, plane, sides);
  }
};

/// Those of all pictures.
struct ExactFaces {
  using Query = RayQuery;
  static Query query(const World& world, const Ray& ray) { return ExactShapes::query(world, ray); }
  static double triangle(const Query& ray, const Vec3* vertices, Sides sides) {
    return hit_triangle(ray, vertices, sides);
  }
  static double polygon(const Query& ray, std::span<const Vec3> vertices, const PolygonPlane& plane,
                        Sides sides) {
    return hit_polygon(ray, vertices, plane, sides);
  }
};

struct FloatQuadrics {
  using Query = TextbookRay<float>;
  static Query query(const World&, const Ray& ray) { return Query(ray); }
  static double sphere(const Query& ray, const Sphere& sphere, Sides sides) {
    return hit_sphere_textbook(ray, sphere, sides);
  }
  static double cone(const Query& ray, const Cone& cone, const ConeFrame&, Sides sides) {
    return hit_cone_textbook(ray, cone, sides);
  }
};

/// Those of all pictures: in double.
struct DoubleQuadrics {
  using Query = RayQuery;
  static Query query(const World&, const Ray& ray) { return Query(ray); }
  static double sphere(const Query& ray, const Sphere& sphere, Sides sides) {
    return hit_sphere(ray, sphere, sides);
  }
  static double cone(const Query& ray, const Cone&, const ConeFrame& frame, Sides sides) {
    return hit_cone(ray, frame, sides);
  }
};

template <class Faces, class Quadrics>
struct MixedShapes {
  struct Query {
    typename Faces::Query face;
    typename Quadrics::Query quadric;
  };
  static Query query(const World& world, const Ray& ray) {
    return {Faces::query(world, ray), Quadrics::query(world, ray)};
  }
  static double hit(const Scene& scene, std::uint32_t id, const Query& ray, SideRule rule) {
    const Object& object = scene.objects[id];
    const Sides sides = visible_sides(scene, object, rule);
    switch (object.kind) {
      case ObjectKind::triangle:
        return Faces::triangle(ray.face, &scene.vertices[scene.faces[object.shape].first_vertex],
                               sides);
      case ObjectKind::polygon: {
        const Face& face = scene.faces[object.shape];
        return Faces::polygon(ray.face, vertices_of(scene, face), scene.planes[face.plane], sides);
      }
      case ObjectKind::sphere:
        return Quadrics::sphere(ray.quadric, scene.spheres[object.shape], sides);
      case ObjectKind::cone:
        break;
    }
    return Quadrics::cone(ray.quadric, scene.cones[object.shape], scene.cone_frames[object.shape],
                          sides);
  }
};

}  // namespace bspview
