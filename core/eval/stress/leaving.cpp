// T14 and T15: a ray that leaves a surface never meets it again where it leaves, and misses nothing
// that lies closely behind.

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/eval/stress/forest.h"
#include "core/eval/stress/mesh.h"
#include "core/eval/stress/rows.h"
#include "core/eval/stress/scenes.h"

namespace bspview::stress {
namespace {

/// A ray that starts on a surface, and what it may meet of the object it leaves.
struct LeavingRay {
  Ray ray;
  std::uint32_t object = no_index;
  double nearest = no_hit;  ///< the object itself may be met from here on; no_hit: nowhere
};

/// Where the inside of a hollow object is met again at the earliest: the largest ball inside that
/// touches the surface at the point has the distance to the axis (the sphere's centre) as radius.
/// Halved, since the point and the object's box are rounded.
double earliest_return(const Scene& scene, const Object& object, const Surface& surface,
                       Vec3d direction) {
  const double slope = glm::dot(direction, surface.normal) / glm::dot(direction, direction);
  if (object.kind == ObjectKind::sphere) {
    return slope * std::abs(double{scene.spheres[object.shape].radius});
  }
  const Cone& cone = scene.cones[object.shape];
  const Vec3d axis = glm::normalize(Vec3d(cone.apex) - Vec3d(cone.base));
  const Vec3d from_base = surface.point - Vec3d(cone.base);
  return slope * glm::length(from_base - glm::dot(from_base, axis) * axis);
}

/// Whether the outside of a hollow object lies on the side of `direction`.
bool leads_outside(const Scene& scene, const Object& object, const Surface& surface,
                   Vec3d direction) {
  const Vec3d inner =
      object.kind == ObjectKind::sphere ? Vec3d(scene.spheres[object.shape].centre) : Vec3d(0.0);
  if (object.kind == ObjectKind::sphere) {
    return glm::dot(surface.point - inner, direction) > 0.0;
  }
  return glm::dot(cone_normal(scene.cones[object.shape], surface.point), direction) > 0.0;
}

/// Leaves on the side that the ray came from or, through the surface, on the other one. Nullopt
/// where the direction grazes the surface more than its rounding allows.
std::optional<LeavingRay> leave(const Subject& subject, const Scene& scene, const Hit& hit,
                                const Ray& ray, Dice& dice) {
  const Surface surface = surface_at(scene, ray, hit);
  const Object& object = scene.objects[hit.object];
  const bool hollow = object.kind == ObjectKind::sphere || object.kind == ObjectKind::cone;
  const Vec3 direction = dice.power_of_ten(-3.0f, 3.0f) * dice.direction();
  const double slope = glm::dot(Vec3d(direction), surface.normal);
  const double length = glm::length(Vec3d(direction));
  const Vec3 origin = subject.leaving(surface, Vec3d(direction));
  LeavingRay leaving{{origin, direction}, hit.object};
  if (!hollow || leads_outside(scene, object, surface, Vec3d(direction))) return leaving;
  if (std::abs(slope) < 0.01 * length) return std::nullopt;
  Surface inner = surface;
  if (slope < 0.0) inner.normal = -inner.normal;
  leaving.nearest = earliest_return(scene, object, inner, Vec3d(direction));
  return leaving;
}

Complaint describe_return(const Scene& scene, const LeavingRay& leaving, double t) {
  return fmt::format(
      "{}: {} leaves object {}: expected to meet it at {:a} at the earliest, met at {:a}",
      scene.name, describe(leaving.ray), leaving.object, leaving.nearest, t);
}

/// One object of that kind, away from the origin by up to 1000 times its size.
Scene lonely_object(ObjectKind kind, Dice& dice) {
  const float size = dice.power_of_ten(-8.0f, 8.0f);
  const float distance = dice.one_in(2) ? 1.0f : 1000.0f;
  Scene scene;
  scene.name = fmt::format("object of size {:g}", size);
  add_random(scene, kind, size * dice.point(distance), size, dice);
  return scene;
}

/// Many rays leave one lonely object.
Complaint leave_lonely_object(const Subject& subject, Dice& dice) {
  constexpr int rays = 100;
  const Scene scene = lonely_object(static_cast<ObjectKind>(dice.trial() % kind_count), dice);
  const Aabb box = object_bounds(scene, 0);
  if (box.empty() || is_degenerate(scene, 0)) return std::nullopt;
  for (int i = 0; i < rays; ++i) {
    const Vec3 target = aim_at(scene, box, Aim::anywhere, dice);
    const Vec3 origin = box.centre() + 2.0f * largest_component(box.extent()) * dice.direction();
    const Ray ray{origin, target - origin};
    const double t = subject.shape(scene, 0, ray, box);
    if (t == no_hit) continue;
    const auto leaving = leave(subject, scene, {t, 0, no_leaf}, ray, dice);
    if (!leaving) continue;
    const double again = subject.shape(scene, 0, leaving->ray, box);
    if (again < leaving->nearest) return describe_return(scene, *leaving, again);
  }
  return std::nullopt;
}

Result<Trial> prepare_leaving_in_scene(const Setting& setting) {
  const auto forest = setting.forest();
  if (!forest) return forest.error();
  return Trial([subject = setting.subject, forest = *forest](Dice& dice) -> Complaint {
    const Scene& scene = *forest->scene;
    const Aabb& box = forest->brute.bounds();
    const Ray ray = ray_towards(aim_at(scene, box, Aim::anywhere, dice), box, dice);
    const Tree& tree = choose_tree(*forest, dice);
    RayCost cost;
    const Hit hit = subject.closest({scene, tree}, ray, cost);
    if (!hit) return std::nullopt;
    const auto leaving = leave(subject, scene, hit, ray, dice);
    if (!leaving) return std::nullopt;
    const Hit next = subject.closest({scene, tree}, leaving->ray, cost);
    if (next.object != hit.object || next.t >= leaving->nearest) return std::nullopt;
    return describe_return(scene, *leaving, next.t);
  });
}

/// Two parallel surfaces of one kind, the second `gap` behind the first.
Scene parallel_pair(bool curved, float gap, Vec3 place, Dice& dice) {
  Scene scene;
  scene.name = curved ? "shells" : "parallel squares";
  scene.materials.resize(1);
  if (curved) {
    const float radius = 1.0f + dice.unit();
    add_sphere(scene, 0, {place, radius + gap});
    add_sphere(scene, 0, {place, radius});
    return scene;
  }
  const Vec3 normal = dice.one_in(2) ? Vec3(0.0f, 0.0f, 1.0f) : dice.direction();
  // Wide enough for a ray that slants by 70 degrees.
  const float half = 3.0f + 4.0f * gap;
  const Vec3 u = half * glm::normalize(glm::cross(normal, dice.direction()));
  const Vec3 v = glm::cross(normal, u);
  for (const float depth : {0.0f, -gap}) {
    const Vec3 middle = place + depth * normal;
    add_face(scene, 0, std::array{middle - u - v, middle + u - v, middle + u + v});
    add_face(scene, 0, std::array{middle - u - v, middle + u + v, middle - u + v});
  }
  return scene;
}

}  // namespace

Result<Trial> prepare_leaving_rays(const Setting& setting) {
  if (setting.scene) return prepare_leaving_in_scene(setting);
  return Trial(
      [subject = setting.subject](Dice& dice) { return leave_lonely_object(subject, dice); });
}

Result<Trial> prepare_narrow_gaps(const Setting& setting) {
  return Trial([subject = setting.subject](Dice& dice) -> Complaint {
    const bool curved = dice.one_in(3);
    const Vec3 place = dice.power_of_ten(0.0f, curved ? 3.0f : 5.0f) * dice.direction();
    // A point is off by half an ulp of its coordinates, and leaving adds at most that and two more.
    const float ulp = 0x1p-23f * (largest_component(magnitudes(place)) + 3.0f);
    const float gap = dice.between(8.0f, 64.0f) * ulp;
    const Scene scene = parallel_pair(curved, gap, place, dice);
    const BruteForce brute(scene);
    const Vec3 outside = place + 4.0f * dice.direction();
    const Ray ray{outside, place + dice.point(0.4f) - outside};
    const Hit first = brute.closest(ray);
    if (!first) return std::nullopt;
    const Surface surface = surface_at(scene, ray, first);
    if (glm::dot(surface.normal, glm::normalize(Vec3d(ray.direction))) > -0.3) return std::nullopt;
    const Vec3 origin = subject.leaving(surface, Vec3d(ray.direction));
    const Hit second = brute.closest({origin, ray.direction});
    const double distance = second.t * glm::length(Vec3d(ray.direction));
    if (second && distance < 10.0 * gap && second.object != first.object) return std::nullopt;
    return fmt::format(
        "{}: {}: expected to meet the surface {:a} behind object {}, found {} from "
        "{:a} {:a} {:a}",
        scene.name, describe(ray), gap, first.object, describe(second), origin.x, origin.y,
        origin.z);
  });
}

}  // namespace bspview::stress
