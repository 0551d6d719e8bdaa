// T19: spheres, cones and cylinders far away and at their tangents, against float128.

#include <fmt/format.h>

#include <cmath>

#include "core/eval/exact_hit.h"
#include "core/eval/stress/forest.h"
#include "core/eval/stress/rows.h"
#include "core/eval/stress/scenes.h"

namespace bspview::stress {
namespace {

constexpr double float_ulp = 0x1p-23;

Vec3d centre_of(const Scene& scene) {
  if (!scene.spheres.empty()) return Vec3d(scene.spheres[0].centre);
  return 0.5 * (Vec3d(scene.cones[0].base) + Vec3d(scene.cones[0].apex));
}

/// From up to 1e6 sizes away; a third is aimed so as to graze the sphere around the object.
Ray far_ray(const Scene& scene, double size, Dice& dice) {
  const Vec3d centre = centre_of(scene);
  const double distance = dice.power_of_ten(-0.5f, 6.0f);
  const Vec3d way(dice.direction());
  const Vec3 origin(centre + size * distance * way);
  Vec3d target = centre + size * Vec3d(dice.point(1.0f));
  if (dice.one_in(3)) {
    const Vec3d beside = glm::normalize(glm::cross(way, Vec3d(dice.direction())));
    target = centre + size * (1.0 + dice.sign() * dice.power_of_ten(-9.0f, -1.0f)) * beside;
  }
  return {origin, Vec3(target - Vec3d(origin))};
}

/// A quadric of a scene of one, and the size that its tangents are measured by.
struct Quadric {
  Scene scene;
  double size = 0.0;
};

Quadric random_quadric(Dice& dice) {
  const float size = dice.power_of_ten(-4.0f, 4.0f);
  Quadric quadric;
  const auto kind = dice.one_in(2) ? ObjectKind::sphere : ObjectKind::cone;
  add_random(quadric.scene, kind, size * dice.point(10.0f), size, dice);
  quadric.size = kind == ObjectKind::sphere ? std::abs(quadric.scene.spheres[0].radius) : size;
  return quadric;
}

/// 1 ulp; at a tangent, whose chord is shorter than 2^-10 of the radius, the length of that too.
bool agrees(double t, const ExactHit& exact, double chord) {
  const double slack = exact.meeting == Meeting::undecided ? 0x1p-10 * chord : 0.0;
  return std::abs(t - exact.t) <= float_ulp * std::abs(exact.t) + slack;
}

bool is_right(double t, const ExactHits& exact, double chord) {
  for (const ExactHit& meeting : exact) {
    const bool sure = meeting.meeting == Meeting::interior || meeting.meeting == Meeting::border;
    if (t == no_hit && sure) return false;
    if (t != no_hit && meeting.meeting != Meeting::miss && agrees(t, meeting, chord)) return true;
  }
  return t == no_hit;
}

}  // namespace

Result<Trial> prepare_far_quadrics(const Setting& setting) {
  return Trial([subject = setting.subject](Dice& dice) -> Complaint {
    const Quadric quadric = random_quadric(dice);
    const Ray ray = far_ray(quadric.scene, quadric.size, dice);
    const ExactHits exact = exact_hits(quadric.scene, 0, ray, Sides::both);
    const double t = subject.shape(quadric.scene, 0, ray, object_bounds(quadric.scene, 0));
    const double chord = quadric.size / glm::length(Vec3d(ray.direction));
    if (is_right(t, exact, chord)) return std::nullopt;
    return fmt::format("{}: {}: expected {:a} or {:a}, found {:a}",
                       describe_object(quadric.scene, 0), describe(ray), exact[0].t, exact[1].t, t);
  });
}

}  // namespace bspview::stress
