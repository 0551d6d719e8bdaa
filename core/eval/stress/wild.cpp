// T17: objects made of random bits do no harm to others, and are hit where arithmetic reaches.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/eval/exact_hit.h"
#include "core/eval/stress/forest.h"
#include "core/eval/stress/mesh.h"
#include "core/eval/stress/rows.h"
#include "core/eval/stress/scenes.h"

namespace bspview::stress {
namespace {

constexpr int pairs = 20;  ///< of a small sphere and a wild object behind it in the list

/// Any float, but mostly one of a size that is traced.
float wild_number(Dice& dice) {
  if (dice.one_in(3)) return dice.any_float();
  return dice.sign() * dice.power_of_ten(-20.0f, 20.0f);
}

float wild_coordinate(Dice& dice) {
  return dice.one_in(2) ? dice.between(-1.0f, 1.0f) : wild_number(dice);
}

Vec3 wild_point(Dice& dice) {
  const float x = wild_coordinate(dice), y = wild_coordinate(dice);
  return {x, y, wild_coordinate(dice)};
}

/// Half of them lie in a plane exactly, across an axis.
void add_wild_face(Scene& scene, Dice& dice) {
  std::vector<Vec3> vertices(static_cast<std::size_t>(3 + dice.below(3)));
  const bool planar = dice.one_in(2);
  const int axis = dice.below(3);
  for (Vec3& vertex : vertices) {
    vertex = wild_point(dice);
    if (planar) vertex[axis] = vertices[0][axis];
  }
  add_face(scene, 0, vertices);
}

/// Half of them have a length and radii of one size.
void add_wild_cone(Scene& scene, Dice& dice) {
  Cone cone{wild_point(dice), wild_number(dice), wild_point(dice), wild_number(dice)};
  if (dice.one_in(2)) {
    const float size = wild_coordinate(dice);
    cone.base_radius = size * dice.power_of_ten(-2.0f, 0.0f);
    cone.apex_radius = size * dice.power_of_ten(-2.0f, 0.0f);
    cone.apex = cone.base + size * dice.direction();
  }
  add_cone(scene, 0, cone);
}

void add_wild(Scene& scene, Dice& dice) {
  switch (dice.below(3)) {
    case 0:
      return add_wild_face(scene, dice);
    case 1:
      return add_sphere(scene, 0, {wild_point(dice), wild_number(dice)});
    default:
      return add_wild_cone(scene, dice);
  }
}

Scene wild_scene(Dice& dice) {
  Scene scene;
  scene.name = "wild scene";
  scene.materials.resize(1);
  for (int i = 0; i < pairs; ++i) {
    add_sphere(scene, 0, {dice.point(1.0f), dice.between(0.05f, 0.2f)});
    add_wild(scene, dice);
  }
  return scene;
}

/// Quadrics are solved in double: right up to this many times their size away.
constexpr double farthest = 1e6;
/// A cone's length and radii differ by no more than this factor: where one is narrower, the squares
/// of the wide end leave nothing of it.
constexpr double thinnest = 1e-3;

bool is_in_reach(const Cone& cone, Vec3 origin) {
  const Vec3d base(cone.base), apex(cone.apex);
  const auto [least, most] =
      std::minmax({glm::length(apex - base), std::abs(double{cone.base_radius}),
                   std::abs(double{cone.apex_radius})});
  const double distance = glm::length(0.5 * (base + apex) - Vec3d(origin));
  return thinnest * most <= least && distance <= farthest * least;
}

bool is_planar(std::span<const Vec3> vertices) {
  const auto is_across = [&](int axis) {
    return std::ranges::all_of(vertices, [&](Vec3 p) { return p[axis] == vertices[0][axis]; });
  };
  return vertices.size() == 3 || is_across(0) || is_across(1) || is_across(2);
}

/// Whether the ray starts where objects may be, and no component of its direction but 0 is so far
/// below another that the walk, in float, takes it for 0.
bool is_in_range(const Ray& ray) {
  const float least = 0x1p-126f * largest_component(magnitudes(ray.direction));
  for (int axis = 0; axis < 3; ++axis) {
    const float d = std::abs(ray.direction[axis]);
    if (!(std::abs(ray.origin[axis]) <= max_coordinate) || !(d == 0.0f || d >= least)) return false;
  }
  return true;
}

/// Whether it is defined where the ray hits the object. Left open are polygons that are not planar
/// and quadrics beyond double.
bool is_defined(const Scene& scene, std::uint32_t id, const Ray& ray) {
  if (!is_in_range(ray) || is_degenerate(scene, id)) return false;
  const Object& object = scene.objects[id];
  switch (object.kind) {
    case ObjectKind::triangle:
      return true;
    case ObjectKind::polygon:
      return is_planar(vertices_of(scene, scene.faces[object.shape]));
    case ObjectKind::sphere: {
      const auto& [centre, radius] = scene.spheres[object.shape];
      return glm::length(Vec3d(centre) - Vec3d(ray.origin)) <= farthest * std::abs(radius);
    }
    case ObjectKind::cone:
      break;
  }
  return is_in_reach(scene.cones[object.shape], ray.origin);
}

/// A wild ray, or one at some object from beside it, from amidst the others or from anywhere.
Ray wild_ray(const Scene& scene, Dice& dice) {
  const auto id = static_cast<std::uint32_t>(dice.below(2 * pairs));
  const Aabb own = object_bounds(scene, id);
  const Object& object = scene.objects[id];
  if (own.empty() || dice.one_in(8)) {
    return {wild_point(dice), wild_point(dice), wild_number(dice), wild_number(dice)};
  }
  Vec3 target = aim_at({}, own, Aim::anywhere, dice);
  if (object.kind == ObjectKind::triangle || object.kind == ObjectKind::polygon) {
    const auto vertices = vertices_of(scene, scene.faces[object.shape]);
    const float u = dice.unit(), v = dice.one_in(4) ? 0.0f : (1.0f - u) * dice.unit();
    target = vertices[0] + u * (vertices[1] - vertices[0]) + v * (vertices[2] - vertices[0]);
  }
  const Vec3 beside = target + 2.0f * largest_component(own.extent()) * dice.direction();
  const Vec3 origin = dice.one_in(2)   ? beside
                      : dice.one_in(2) ? dice.point(3.0f)
                                       : wild_point(dice);
  return {origin, target - origin};
}

/// The nearest hit of the objects for which it is defined.
Hit nearest_defined(const Subject& subject, const Forest& forest, const Ray& ray) {
  Hit best;
  for (std::uint32_t id = 0; id < forest.scene->objects.size(); ++id) {
    if (!is_defined(*forest.scene, id, ray)) continue;
    const double t = subject.shape(*forest.scene, id, ray, forest.brute.bounds());
    if (t < best.t) best = {t, id, no_leaf};
  }
  return best;
}

/// An answer is that nearest hit, or one of the others in front of it.
bool is_allowed(const Scene& scene, const Ray& ray, const Hit& found, const Hit& nearest) {
  if (found.object == nearest.object) return found.t == nearest.t;
  if (!found || found.object >= scene.objects.size()) return false;
  return !is_degenerate(scene, found.object) && !is_defined(scene, found.object, ray) &&
         found.t <= nearest.t && ray.t_min < found.t && found.t < ray.t_max;
}

/// Every tree finds what brute force finds.
Complaint compare_trees(const Subject& subject, const Forest& forest, const Ray& ray,
                        const Hit& nearest) {
  for (const Tree& tree : forest.trees) {
    for (const World& world : forest.worlds(tree)) {
      RayCost cost;
      const Hit found = subject.closest(world, ray, cost);
      if (is_allowed(*forest.scene, ray, found, nearest)) continue;
      const std::uint32_t id = nearest ? nearest.object : found.object;
      return fmt::format("{}: {}: expected {}, found {}; object {} is {}", describe(world),
                         describe(ray), describe(nearest), describe(found), id,
                         describe_object(*forest.scene, id));
    }
  }
  return std::nullopt;
}

/// Brute force finds what exact arithmetic finds of triangles: no surely hit one lies in front of
/// the nearest, and the nearest is hit, at that distance.
Complaint compare_triangles(const Forest& forest, const Ray& ray, const Hit& nearest) {
  constexpr double two_ulp = 0x1p-22;
  for (std::uint32_t id = 0; id < forest.scene->objects.size(); ++id) {
    const bool is_triangle = forest.scene->objects[id].kind == ObjectKind::triangle;
    if (!is_triangle || !is_defined(*forest.scene, id, ray)) continue;
    const ExactHit exact = exact_hits(*forest.scene, id, ray, Sides::both)[0];
    const double slack = two_ulp * std::abs(exact.t);
    const bool met = exact.meeting != Meeting::miss;
    const bool sure = met && exact.meeting != Meeting::undecided;
    const bool lost = sure && exact.t + slack < nearest.t;
    const bool phantom = nearest.object == id && !(met && std::abs(exact.t - nearest.t) <= slack);
    if (!lost && !phantom) continue;
    return fmt::format("{}: brute force finds {}, which exact arithmetic on triangle {} at {:a} {}",
                       describe(ray), describe(nearest), id, exact.t,
                       lost ? "calls lost" : "calls a phantom");
  }
  return std::nullopt;
}

/// The small sphere must be hit, or something in front of it.
Complaint shoot_at_valid(const Subject& subject, const Forest& forest, Dice& dice) {
  const Scene& scene = *forest.scene;
  const Sphere& sphere =
      scene.spheres[scene.objects[static_cast<std::size_t>(2 * dice.below(pairs))].shape];
  const Vec3 origin = sphere.centre + dice.between(0.25f, 4.0f) * dice.direction();
  const Ray ray{origin, sphere.centre - origin};
  for (const Tree& tree : forest.trees) {
    for (const World& world : forest.worlds(tree)) {
      RayCost cost;
      const Hit found = subject.closest(world, ray, cost);
      if (found && found.t <= 1.0 + 1e-6) continue;
      return fmt::format("{}: {}: expected a sphere's front, found {}", describe(world),
                         describe(ray), describe(found));
    }
  }
  return std::nullopt;
}

}  // namespace

Result<Trial> prepare_wild_scenes(const Setting& setting) {
  return Trial([subject = setting.subject](Dice& dice) -> Complaint {
    const auto forest =
        grow_forest(std::make_shared<Scene>(wild_scene(dice)), std::span(every_leaf_size).first(1));
    if (!forest) return forest.error().message;
    for (int i = 0; i < 20; ++i) {
      if (auto complaint = shoot_at_valid(subject, **forest, dice)) return complaint;
    }
    for (int i = 0; i < 100; ++i) {
      const Ray ray = wild_ray(*(*forest)->scene, dice);
      const Hit nearest = nearest_defined(subject, **forest, ray);
      if (auto complaint = compare_triangles(**forest, ray, nearest)) return complaint;
      if (auto complaint = compare_trees(subject, **forest, ray, nearest)) return complaint;
    }
    return std::nullopt;
  });
}

}  // namespace bspview::stress
