#pragma once

#include "core/bsp/traverse.h"
#include "core/render/arithmetic.h"
#include "core/render/world.h"
#include "core/shape/cone.h"
#include "core/shape/polygon.h"
#include "core/shape/sphere.h"
#include "core/shape/triangle.h"

namespace bspview {

/// Nearest hit of a ray; ties go to the lower object id.
struct Hit {
  double t = no_hit;
  std::uint32_t object = no_index;
  std::uint32_t leaf = no_leaf;  ///< node index of the leaf that holds the hit point

  explicit operator bool() const { return object != no_index; }
};

/// Which sides of objects a ray sees. The SPD's rules make opaque objects one-sided. They leave
/// open what shadow rays see of transparent ones; fronts only, so that nothing transparent shades
/// its own inside, comes nearest to the published ray counts.
enum class SideRule { two_sided, opaque_one_sided, one_sided };

inline Sides visible_sides(const Scene& scene, const Object& object, SideRule rule) {
  if (rule == SideRule::two_sided || scene.two_sided) return Sides::both;
  if (rule == SideRule::one_sided) return Sides::front;
  return scene.materials[object.material].transmittance > 0.0f ? Sides::both : Sides::front;
}

/// Tests one shape: the single place where a kind of object is told from another.
inline double hit_shape(const Scene& scene, ObjectKind kind, std::uint32_t shape,
                        const RayQuery& ray, Sides sides) {
  switch (kind) {
    case ObjectKind::triangle:
      return hit_triangle(ray, &scene.vertices[scene.faces[shape].first_vertex], sides);
    case ObjectKind::polygon: {
      const Face& face = scene.faces[shape];
      return hit_polygon(ray, vertices_of(scene, face), scene.planes[face.plane], sides);
    }
    case ObjectKind::sphere:
      return hit_sphere(ray, scene.spheres[shape], sides);
    case ObjectKind::cone:
      break;
  }
  return hit_cone(ray, scene.cone_frames[shape], sides);
}

inline double hit_object(const Scene& scene, std::uint32_t id, const RayQuery& ray, SideRule rule) {
  const Object& object = scene.objects[id];
  return hit_shape(scene, object.kind, object.shape, ray, visible_sides(scene, object, rule));
}

/// The tests of all pictures. Another type with the same members tries other tests (core/eval).
struct ExactShapes {
  using Query = RayQuery;
  static Query query(const World& world, const Ray& ray) {
    return RayQuery(ray, reach_of(world.tree.box, ray.origin), has_triangles(world.scene));
  }
  static double hit(const Scene& scene, std::uint32_t id, const Query& ray, SideRule rule) {
    return hit_object(scene, id, ray, rule);
  }
};

/// How rays are traced: the walk, the tests, and what they see.
struct TraceRules {
  Traversal traversal = Traversal::robust;
  SideRule sides = SideRule::two_sided;         ///< closest_hit
  SideRule shadow_sides = SideRule::two_sided;  ///< any_hit
  Arithmetic arithmetic = Arithmetic::exact;    ///< of trace_closest and trace_any
  bool operator==(const TraceRules&) const = default;
};

/// Nearest hit of `ray` in its interval.
template <class Shapes = ExactShapes, class Observer>
Hit closest_hit(const World& world, const Ray& ray, const TraceRules& rules, Observer& observer) {
  const typename Shapes::Query query = Shapes::query(world, ray);
  Hit best;
  const auto leaf = [&](std::uint32_t, const Node& node) {
    for (const std::uint32_t id : world.tree.objects_of(node)) {
      const double t = Shapes::hit(world.scene, id, query, rules.sides);
      const bool better = t < best.t || (t == best.t && t != no_hit && id < best.object);
      if (better) best = {t, id, no_leaf};
      observer.test(id, better, t);
    }
    return best.t;
  };
  const std::uint32_t last = traverse(rules.traversal, world.tree, ray, leaf, observer);
  if (best) best.leaf = last;
  return best;
}

/// Some object that `ray` hits in its interval, the first that the walk meets; no_index: none.
template <class Shapes = ExactShapes, class Observer>
std::uint32_t any_hit(const World& world, const Ray& ray, const TraceRules& rules,
                      Observer& observer) {
  const typename Shapes::Query query = Shapes::query(world, ray);
  std::uint32_t blocker = no_index;
  const auto leaf = [&](std::uint32_t, const Node& node) {
    for (const std::uint32_t id : world.tree.objects_of(node)) {
      const double t = Shapes::hit(world.scene, id, query, rules.shadow_sides);
      observer.test(id, t != no_hit, t);
      if (t == no_hit) continue;
      blocker = id;
      return stop_walk;
    }
    return no_hit;
  };
  traverse(rules.traversal, world.tree, ray, leaf, observer);
  return blocker;
}

}  // namespace bspview
