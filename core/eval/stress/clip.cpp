// T10: the box of a triangle clipped to a cell holds the exact part. T16: points of a surface lie
// in its box.

#include <fmt/format.h>

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/eval/stress/rows.h"
#include "core/eval/stress/scenes.h"
#include "core/math/float_error.h"
#include "core/math/largest_coordinate.h"
#include "core/render/scene_tree.h"

namespace bspview::stress {
namespace {

using Rational = boost::multiprecision::number<boost::multiprecision::cpp_rational_backend,
                                               boost::multiprecision::et_off>;
using Corners = std::array<Vec3, 3>;

template <class Number>
using Polygon = std::vector<std::array<Number, 3>>;

/// The points p of `polygon` with sign p[axis] >= sign limit (Sutherland & Hodgman 1974).
template <class Number>
Polygon<Number> cut(const Polygon<Number>& polygon, int axis, int sign, const Number& limit) {
  const auto i = static_cast<std::size_t>(axis);
  const auto is_inside = [&](const std::array<Number, 3>& p) {
    return sign > 0 ? p[i] >= limit : p[i] <= limit;
  };
  Polygon<Number> part;
  for (std::size_t n = 0; n < polygon.size(); ++n) {
    const auto& p = polygon[n];
    const auto& q = polygon[(n + 1) % polygon.size()];
    if (is_inside(p)) part.push_back(p);
    if (is_inside(p) == is_inside(q)) continue;
    const Number share = (limit - p[i]) / (q[i] - p[i]);
    std::array<Number, 3> crossing;
    for (std::size_t k = 0; k < 3; ++k) crossing[k] = p[k] + share * (q[k] - p[k]);
    crossing[i] = limit;
    part.push_back(crossing);
  }
  return part;
}

template <class Number>
Polygon<Number> clip(const Corners& corners, const Aabb& cell) {
  Polygon<Number> polygon;
  for (const Vec3 p : corners) polygon.push_back({Number(p.x), Number(p.y), Number(p.z)});
  for (int axis = 0; axis < 3; ++axis) {
    polygon = cut(polygon, axis, 1, Number(cell.lo[axis]));
    polygon = cut(polygon, axis, -1, Number(cell.hi[axis]));
  }
  return polygon;
}

template <class Number>
bool holds(const Aabb& box, const Polygon<Number>& polygon, double margin) {
  for (const auto& p : polygon) {
    for (int axis = 0; axis < 3; ++axis) {
      const Number& x = p[static_cast<std::size_t>(axis)];
      if (!(x >= Number(box.lo[axis]) + Number(margin))) return false;
      if (!(x <= Number(box.hi[axis]) - Number(margin))) return false;
    }
  }
  return true;
}

double magnitude(const Corners& corners, const Aabb& cell) {
  Vec3 largest = glm::max(magnitudes(cell.lo), magnitudes(cell.hi));
  for (const Vec3 p : corners) largest = glm::max(largest, magnitudes(p));
  return largest_component(largest);
}

/// Whether double is enough to see that `box` holds the exact part: it does so with room to spare,
/// and so does the part of a cell that is a little larger.
bool surely_holds(const Aabb& box, const Corners& corners, const Aabb& cell) {
  // Six cuts in double are off by less than 2^-48 of the largest coordinate.
  const double margin = 0x1p-44 * magnitude(corners, cell);
  Polygon<double> polygon;
  for (const Vec3 p : corners) polygon.push_back({p.x, p.y, p.z});
  for (int axis = 0; axis < 3; ++axis) {
    polygon = cut(polygon, axis, 1, cell.lo[axis] - margin);
    polygon = cut(polygon, axis, -1, cell.hi[axis] + margin);
  }
  return polygon.empty() || (!box.empty() && holds(box, polygon, margin));
}

/// A cell that cuts the triangle, often through its corners or just beside them.
Aabb random_cell(const Corners& corners, float size, Dice& dice) {
  Aabb cell;
  for (const float at : {0.0f, 1.0f}) {
    Vec3 corner = corners[static_cast<std::size_t>(dice.below(3))] + dice.point(size);
    for (int axis = 0; axis < 3; ++axis) {
      const float of_vertex = corners[static_cast<std::size_t>(dice.below(3))][axis];
      if (dice.one_in(8)) corner[axis] = of_vertex;
      if (dice.one_in(32)) corner[axis] = at == 0.0f ? next_up(of_vertex) : next_down(of_vertex);
    }
    cell.grow(corner);
  }
  return cell;
}

Corners random_corners(float size, Dice& dice) {
  const std::array distances{0.0f, 1.0f, 100.0f, 200'000.0f};
  const Vec3 place = distances[static_cast<std::size_t>(dice.below(4))] * size * dice.direction();
  Corners corners{place + dice.point(size), place + dice.point(size), place + dice.point(size)};
  if (dice.one_in(8)) corners[1] = corners[0] + 1e-4f * dice.point(size);  // a needle
  if (dice.one_in(8)) {
    const int axis = dice.below(3);
    for (Vec3& corner : corners) corner[axis] = place[axis];
  }
  return corners;
}

std::string describe(const Aabb& box) {
  return fmt::format("[{:a} {:a} {:a}, {:a} {:a} {:a}]", box.lo.x, box.lo.y, box.lo.z, box.hi.x,
                     box.hi.y, box.hi.z);
}

/// A point of the surface, computed in double.
Vec3d point_on(const Scene& scene, std::uint32_t id, Dice& dice) {
  const Object& object = scene.objects[id];
  const double turn = 2.0 * std::numbers::pi * dice.unit();
  if (object.kind == ObjectKind::sphere) {
    const Sphere& sphere = scene.spheres[object.shape];
    Vec3d way = glm::normalize(Vec3d(dice.direction()));
    if (dice.one_in(4)) {  // a pole
      way = Vec3d(0.0);
      way[dice.below(3)] = dice.sign();
    }
    return Vec3d(sphere.centre) + double{sphere.radius} * way;
  }
  if (object.kind == ObjectKind::cone) {
    const Cone& cone = scene.cones[object.shape];
    const Vec3d axis = Vec3d(cone.apex) - Vec3d(cone.base);
    const Vec3d u = glm::normalize(glm::cross(axis, Vec3d(dice.direction())));
    const Vec3d v = glm::cross(glm::normalize(axis), u);
    const double s = dice.one_in(4) ? dice.below(2) : dice.unit();
    const double radius = (1.0 - s) * cone.base_radius + s * cone.apex_radius;
    return Vec3d(cone.base) + s * axis + radius * (std::cos(turn) * u + std::sin(turn) * v);
  }
  // On a border: that of a polygon decides its box.
  const auto vertices = vertices_of(scene, scene.faces[object.shape]);
  const auto corner = static_cast<std::size_t>(dice.below(static_cast<int>(vertices.size())));
  const Vec3d a(vertices[corner]), b(vertices[(corner + 1) % vertices.size()]);
  return a + static_cast<double>(dice.unit()) * (b - a);
}

/// `box`, larger by what computing a point in double is off by.
bool holds_point(const Aabb& box, Vec3d point, double size) {
  if (box.empty()) return false;
  const Vec3d slack(0x1p-46 * size);
  for (int axis = 0; axis < 3; ++axis) {
    if (point[axis] < box.lo[axis] - slack[axis] || point[axis] > box.hi[axis] + slack[axis]) {
      return false;
    }
  }
  return true;
}

Complaint check_point(const Subject& subject, const Scene& scene, std::uint32_t id, Dice& dice) {
  if (object_bounds(scene, id).empty() || is_degenerate(scene, id)) return std::nullopt;
  const Vec3d point = point_on(scene, id, dice);
  const Aabb box = subject.bounds(scene, id);
  const double size = double{largest_coordinate(box)};
  if (holds_point(box, point, size)) return std::nullopt;
  return fmt::format("{}: object {}: expected point {:a} {:a} {:a} inside its box, found {}",
                     scene.name, id, point.x, point.y, point.z, describe(box));
}

}  // namespace

Result<Trial> prepare_exact_clipping(const Setting& setting) {
  return Trial([subject = setting.subject](Dice& dice) -> Complaint {
    const float size = dice.one_in(2) ? 1.0f : dice.power_of_ten(-6.0f, 6.0f);
    const Corners corners = random_corners(size, dice);
    const Aabb cell = random_cell(corners, size, dice);
    const Aabb box = subject.clip(corners, cell);
    if (surely_holds(box, corners, cell)) return std::nullopt;
    const auto exact = clip<Rational>(corners, cell);
    if (exact.empty() || (!box.empty() && holds(box, exact, 0.0))) return std::nullopt;
    std::string text = "triangle";
    for (const Vec3 p : corners) text += fmt::format(" ({:a} {:a} {:a})", p.x, p.y, p.z);
    return fmt::format("{}, cell {}: expected the exact part inside, found {}", text,
                       describe(cell), describe(box));
  });
}

Result<Trial> prepare_points_in_boxes(const Setting& setting) {
  return Trial([subject = setting.subject, given = setting.scene](Dice& dice) -> Complaint {
    if (given) {
      const auto id =
          static_cast<std::uint32_t>(dice.below(static_cast<int>(given->objects.size())));
      return check_point(subject, *given, id, dice);
    }
    const float size = dice.power_of_ten(-8.0f, 8.0f);
    Scene scene;
    scene.name = "object";
    add_random(scene, static_cast<ObjectKind>(dice.trial() % kind_count),
               size * dice.point(dice.one_in(2) ? 1.0f : 1000.0f), size, dice);
    return check_point(subject, scene, 0, dice);
  });
}

}  // namespace bspview::stress
