// T01 to T03: single triangles against exact arithmetic.

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/eval/exact_hit.h"
#include "core/eval/exact_sign.h"
#include "core/eval/stress/forest.h"
#include "core/eval/stress/rows.h"
#include "core/eval/stress/scenes.h"

namespace bspview::stress {
namespace {

constexpr double ulp = 0x1p-23;  // of float, relative
using Corners = std::array<Vec3, 3>;

Scene scene_of(const Corners& corners) {
  Scene scene;
  scene.name = "triangle";
  scene.materials.resize(1);
  add_face(scene, 0, corners);
  return scene;
}

/// Weights of the second and third corner at the point where the ray meets the plane, correctly
/// rounded.
struct Weights {
  double u, v;
};
Weights exact_weights(const Ray& ray, const Corners& corners) {
  using Fine = Vec3Of<Unrounded>;
  const Fine d(ray.direction), o(ray.origin);
  const Fine a = Fine(corners[0]) - o, b = Fine(corners[1]) - o, c = Fine(corners[2]) - o;
  const Unrounded of_a = dot(d, cross(c, b)), of_b = dot(d, cross(a, c)),
                  of_c = dot(d, cross(b, a));
  const Unrounded area = of_a + of_b + of_c;
  return {Unrounded(of_b / area).convert_to<double>(), Unrounded(of_c / area).convert_to<double>()};
}

/// A point inside a triangle, away from its border by a share of its size.
Vec3d point_inside(const Corners& corners, Dice& dice) {
  double u = dice.between(0.02f, 0.96f), v = dice.between(0.02f, 0.96f);
  if (u + v > 0.98) {
    u = 0.98 - u;
    v = 0.98 - v;
  }
  if (u < 0.01 || v < 0.01) u = v = 1.0 / 3.0;
  return (1.0 - u - v) * Vec3d(corners[0]) + u * Vec3d(corners[1]) + v * Vec3d(corners[2]);
}

/// Whether a ray meets a triangle at an angle at which t and the weights are well defined in float.
bool is_well_posed(const Ray& ray, const Corners& corners) {
  const Vec3d normal = triangle_normal(corners[0], corners[1], corners[2]);
  const double longest = std::max({glm::length(Vec3d(corners[1] - corners[0])),
                                   glm::length(Vec3d(corners[2] - corners[1])),
                                   glm::length(Vec3d(corners[0] - corners[2]))});
  const double area = glm::length(normal);
  const double slope = std::abs(glm::dot(normal, Vec3d(ray.direction)));
  return area > 0.02 * longest * longest && slope > 0.02 * area * glm::length(Vec3d(ray.direction));
}

/// A triangle and a ray from nearby that exact arithmetic finds inside it.
struct AimedTriangle {
  Corners corners;
  Scene scene;
  Ray ray;
  double exact_t = no_hit;
};

AimedTriangle aim_inside(const Corners& corners, Dice& dice) {
  AimedTriangle aimed{corners, scene_of(corners)};
  const double distance = 3.0 * largest_component(object_bounds(aimed.scene, 0).extent());
  constexpr int attempts = 20;  // what is no wider than an ulp can be impossible to aim at
  for (int i = 0; i < attempts; ++i) {
    const Vec3d target = point_inside(corners, dice);
    const Vec3 origin(target + distance * Vec3d(dice.direction()));
    aimed.ray = {origin, Vec3(target - Vec3d(origin))};
    const auto hits = exact_hits(aimed.scene, 0, aimed.ray, Sides::both);
    if (hits[0].meeting != Meeting::interior) continue;
    aimed.exact_t = hits[0].t;
    break;
  }
  return aimed;
}

/// Until a ray meets a triangle at an angle, and far enough from being flat, for t and the weights
/// to be well defined in float.
AimedTriangle well_posed_triangle(Dice& dice) {
  for (;;) {
    const Vec3 place = dice.one_in(2) ? Vec3(0.0f) : dice.point(100.0f);
    const Corners corners{place + dice.point(1.0f), place + dice.point(1.0f),
                          place + dice.point(1.0f)};
    AimedTriangle aimed = aim_inside(corners, dice);
    if (aimed.exact_t != no_hit && is_well_posed(aimed.ray, corners)) return aimed;
  }
}

Complaint judge_inside_hit(const AimedTriangle& aimed, double t) {
  const auto& [corners, scene, ray, exact_t] = aimed;
  const Weights exact = exact_weights(ray, corners);
  const Vec2 found_weights = triangle_weights(ray, corners.data());
  const Vec3d found = Vec3d(ray.origin) + t * Vec3d(ray.direction);
  const Vec3d point = Vec3d(ray.origin) + exact_t * Vec3d(ray.direction);
  const double size = glm::length(point);
  const double t_error = std::abs(t - exact_t) / (ulp * exact_t);
  const double u_error = std::abs(found_weights.x - exact.u) / ulp;
  const double v_error = std::abs(found_weights.y - exact.v) / ulp;
  const double point_error = glm::length(found - point) / (ulp * size);
  if (t_error <= 16 && u_error <= 16 && v_error <= 16 && point_error <= 16) return std::nullopt;
  return fmt::format(
      "{}: {}: expected t, u, v and the point within 16 ulp, found errors of {:.1f}, {:.1f}, "
      "{:.1f} and {:.1f}",
      describe_object(scene, 0), describe(ray), t_error, u_error, v_error, point_error);
}

/// Three points on a line, exactly, or fewer.
Corners flat_corners(Dice& dice) {
  const float size = std::ldexp(1.0f, dice.below(40) - 20);
  const auto small = [&] { return static_cast<float>(dice.below(201) - 100); };
  const Vec3 a(small(), small(), small()), way(small(), small(), small());
  Corners corners{a, a, a};
  switch (dice.below(4)) {
    case 0:
      break;
    case 1:
      corners[1] = a + way;
      break;
    case 2:
      corners[1] = corners[2] = a + way;
      break;
    default:
      corners[1] = a + static_cast<float>(dice.below(20)) * way;
      corners[2] = a - static_cast<float>(dice.below(20)) * way;
  }
  std::swap(corners[0], corners[static_cast<std::size_t>(dice.below(3))]);
  for (Vec3& corner : corners) corner *= size;
  return corners;
}

}  // namespace

Result<Trial> prepare_aimed_triangles(const Setting& setting) {
  return Trial([subject = setting.subject](Dice& dice) -> Complaint {
    const AimedTriangle aimed = well_posed_triangle(dice);
    const double t = subject.shape(aimed.scene, 0, aimed.ray, object_bounds(aimed.scene, 0));
    if (t == no_hit) {
      return fmt::format("{}: {}: expected a hit at {:a}, found nothing",
                         describe_object(aimed.scene, 0), describe(aimed.ray), aimed.exact_t);
    }
    return judge_inside_hit(aimed, t);
  });
}

Result<Trial> prepare_triangle_sizes(const Setting& setting) {
  return Trial([subject = setting.subject](Dice& dice) -> Complaint {
    // Edges of one size, or a needle.
    const float size = dice.power_of_ten(-8.0f, 8.0f);
    const float width = dice.one_in(3) ? dice.power_of_ten(-8.0f, 8.0f) : size;
    const Vec3 corner = dice.point(size);
    const Corners corners{corner, corner + size * dice.direction(),
                          corner + width * dice.direction()};
    const AimedTriangle aimed = aim_inside(corners, dice);
    if (aimed.exact_t == no_hit) return std::nullopt;
    const double t = subject.shape(aimed.scene, 0, aimed.ray, object_bounds(aimed.scene, 0));
    const Vec2 w = triangle_weights(aimed.ray, corners.data());
    const bool inside = w.x >= 0.0f && w.y >= 0.0f && w.x <= 1.0f && w.y <= 1.0f;
    if (std::isfinite(t) && std::abs(t / aimed.exact_t - 1.0) <= ulp && inside) {
      return std::nullopt;
    }
    return fmt::format("{}: {}: expected a hit at {:a}, found {:a} at weights {:a} {:a}",
                       describe_object(aimed.scene, 0), describe(aimed.ray), aimed.exact_t, t, w.x,
                       w.y);
  });
}

Result<Trial> prepare_flat_triangles(const Setting& setting) {
  return Trial([subject = setting.subject](Dice& dice) -> Complaint {
    const Corners corners = flat_corners(dice);
    const Scene scene = scene_of(corners);
    const Aabb box = object_bounds(scene, 0);
    const Vec3d target = point_inside(corners, dice);
    const Vec3 aim =
        dice.one_in(2) ? corners[static_cast<std::size_t>(dice.below(3))] : Vec3(target);
    const float reach = std::max(largest_component(box.extent()), 1e-6f);
    const Vec3 origin = dice.one_in(4) ? corners[0] + 2.0f * (corners[1] - corners[0])
                                       : aim + reach * dice.direction();
    const Ray ray{origin, aim - origin};
    const double t = subject.shape(scene, 0, ray, box);
    const Vec2 weights = triangle_weights(ray, corners.data());
    if (t == no_hit && !std::isnan(weights.x) && !std::isnan(weights.y)) return std::nullopt;
    return fmt::format("{}: {}: expected nothing, found {:a}", describe_object(scene, 0),
                       describe(ray), t);
  });
}

}  // namespace bspview::stress
