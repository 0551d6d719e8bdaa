// Wrong tests of objects.

#include "core/math/float_error.h"
#include "core/render/scene_tree.h"
#include "core/render/textbook_shapes.h"
#include "tests/mutants/mutants.h"

namespace bspview::test {
namespace {

using stress::Subject;

/// closest, occluded and shape with the shape tests of the template.
template <class Shapes>
Subject with_shapes() {
  Subject subject = stress::default_subject();
  subject.closest = [](const World& world, const Ray& ray, RayCost& cost) {
    CountObserver count(cost);
    return closest_hit<Shapes>(world, ray, {}, count);
  };
  subject.occluded = [](const World& world, const Ray& ray) {
    NoObserver none;
    return any_hit<Shapes>(world, ray, {}, none) != no_index;
  };
  subject.shape = [](const Scene& scene, std::uint32_t object, const Ray& ray, const Aabb& all) {
    Tree tree;
    tree.box = all;
    return Shapes::hit(scene, object, Shapes::query({scene, tree}, ray), SideRule::two_sided);
  };
  return subject;
}

/// As hit_woop, but with the contracted edge function and without a second look in double.
struct ContractedFaces : ExactFaces {
  static double triangle(const Query& ray, const Vec3* vertices, Sides sides) {
    const Vec2 a = ray.project(vertices[0]), b = ray.project(vertices[1]),
               c = ray.project(vertices[2]);
    const float u = contracted_edge(c, b), v = contracted_edge(a, c), w = contracted_edge(b, a);
    if (std::min({u, v, w}) < 0.0f && std::max({u, v, w}) > 0.0f) return no_hit;
    return hit_triangle_plane(ray, vertices, sides);
  }
};

Aabb inwards(Aabb box) {
  for (int axis = 0; axis < 3; ++axis) {
    const float lo = next_up(box.lo[axis]), hi = next_down(box.hi[axis]);
    if (lo > hi) continue;
    box.lo[axis] = lo;
    box.hi[axis] = hi;
  }
  return box;
}

}  // namespace

Subject contracted_woop() {
  Subject subject = with_shapes<MixedShapes<ContractedFaces, DoubleQuadrics>>();
  subject.edge = contracted_edge;
  return subject;
}

Subject float_triangles() {
  return with_shapes<MixedShapes<MoellerFaces<float>, DoubleQuadrics>>();
}

Subject float_quadrics() {
  return with_shapes<MixedShapes<ExactFaces, FloatQuadrics>>();
}

Subject no_offset() {
  Subject subject = stress::default_subject();
  subject.leaving = [](const Surface& surface, Vec3d) { return Vec3(surface.point); };
  return subject;
}

Subject boxes_rounded_inwards() {
  Subject subject = stress::default_subject();
  subject.bounds = [](const Scene& scene, std::uint32_t object) {
    return inwards(object_bounds(scene, object));
  };
  subject.clip = [](std::span<const Vec3> vertices, const Aabb& cell) {
    return inwards(clip_polygon(vertices, cell));
  };
  return subject;
}

}  // namespace bspview::test
