#include "core/eval/exact_hit.h"

#include <algorithm>
#include <cmath>

#include "core/eval/exact_sign.h"

namespace bspview {
namespace {

using std::abs;

constexpr double two_ulp = 0x1p-22;  // of float, relative

bool is_ray(const Ray& ray) {
  const Vec3 finite = 0.0f * (ray.origin + ray.direction);
  return finite == Vec3(0.0f) && ray.direction != Vec3(0.0f);
}

/// Sign of det(d, a - o, b - o).
int edge_sign(const Ray& ray, Vec3 a, Vec3 b) {
  return certain_sign([&]<class Number>(Number) {
    const Vec3Of<Number> o(ray.origin), d(ray.direction);
    const Vec3Of<Number> p = Vec3Of<Number>(a) - o, q = Vec3Of<Number>(b) - o;
    Bounded<Number> sum{0, 0};
    for (int axis = 0; axis < 3; ++axis) {
      const int i = (axis + 1) % 3, j = (axis + 2) % 3;
      const Number first = p[i] * q[j], second = p[j] * q[i];
      sum.value += d[axis] * (first - second);
      sum.size += abs(d[axis]) * (abs(first) + abs(second));
    }
    return sum;
  });
}

/// Sign of (a - o)[i] d[j] - (a - o)[j] d[i].
int line_sign(const Ray& ray, Vec3 a, int i, int j) {
  return certain_sign([&]<class Number>(Number) {
    const Vec3Of<Number> o(ray.origin), d(ray.direction), p = Vec3Of<Number>(a) - o;
    const Number first = p[i] * d[j], second = p[j] * d[i];
    return Bounded<Number>{first - second, abs(first) + abs(second)};
  });
}

/// A hit at `t` as the ray's interval lets it be.
ExactHit within(const Ray& ray, Meeting meeting, double t, bool t_is_exact) {
  if (!t_is_exact && (t == ray.t_min || t == ray.t_max)) return {Meeting::undecided, t};
  if (!(ray.t_min < t && t < ray.t_max)) return {};
  return {meeting, t};
}

ExactHit meet_triangle_plane(const Ray& ray, const Vec3* v, Sides sides, Meeting meeting) {
  using Exact = Vec3Of<Unrounded>;
  const Exact a(v[0]);
  const Exact normal = cross(Exact(v[1]) - a, Exact(v[2]) - a);
  const Unrounded slope = dot(normal, Exact(ray.direction));
  if (slope == 0 || (sides == Sides::front && slope > 0)) return {};
  const Unrounded height = dot(normal, a - Exact(ray.origin));
  const Unrounded t = height / slope;
  const double rounded = t.convert_to<double>();
  return within(ray, meeting, rounded, t == Unrounded(rounded));
}

ExactHit meet_triangle(const Scene& scene, const Face& face, const Ray& ray, Sides sides) {
  const Vec3* v = &scene.vertices[face.first_vertex];
  const int u = edge_sign(ray, v[2], v[1]);
  const int w = edge_sign(ray, v[1], v[0]);
  if (u * w < 0) return {};
  const int x = edge_sign(ray, v[0], v[2]);
  if (u * x < 0 || w * x < 0 || (u == 0 && w == 0 && x == 0)) return {};
  const bool border = u == 0 || w == 0 || x == 0;
  return meet_triangle_plane(ray, v, sides, border ? Meeting::border : Meeting::interior);
}

/// Where the ray passes the outline of a polygon, seen along the ray: crossings of a half-plane
/// that starts in the ray are counted.
Meeting meet_outline(const Ray& ray, std::span<const Vec3> vertices) {
  const Vec3 size = magnitudes(ray.direction);
  const int k = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const int i = (k + 1) % 3, j = (k + 2) % 3;
  const int orientation = ray.direction[k] > 0.0f ? 1 : -1;
  bool inside = false;
  for (std::size_t n = 0; n < vertices.size(); ++n) {
    const Vec3 a = vertices[n], b = vertices[(n + 1) % vertices.size()];
    const int a_y = orientation * line_sign(ray, a, j, k);
    const int b_y = orientation * line_sign(ray, b, j, k);
    if (a_y * b_y > 0) continue;
    const int side = orientation * edge_sign(ray, a, b);
    if (a_y == 0 && b_y == 0) {
      if (line_sign(ray, a, i, k) * line_sign(ray, b, i, k) <= 0) return Meeting::border;
    } else if (side == 0) {
      return Meeting::border;
    }
    const bool upwards = a_y <= 0 && b_y > 0, downwards = a_y > 0 && b_y <= 0;
    if ((upwards && side > 0) || (downwards && side < 0)) inside = !inside;
  }
  return inside ? Meeting::interior : Meeting::miss;
}

/// Where the ray leaves the box of the vertices.
Quad exit_of_box(const Ray& ray, std::span<const Vec3> vertices) {
  Quad exit = no_hit;
  for (int axis = 0; axis < 3; ++axis) {
    const float d = ray.direction[axis];
    if (d == 0.0f) continue;
    float side = vertices[0][axis];
    for (const Vec3& v : vertices)
      side = d > 0.0f ? std::max(side, v[axis]) : std::min(side, v[axis]);
    exit = std::min(exit, Quad((Quad(side) - Quad(ray.origin[axis])) / Quad(d)));
  }
  return exit;
}

ExactHit meet_polygon(const Scene& scene, const Face& face, const Ray& ray, Sides sides) {
  using Fine = Vec3Of<Quad>;
  const Meeting meeting = meet_outline(ray, vertices_of(scene, face));
  if (meeting == Meeting::miss) return {};
  const PolygonPlane& plane = scene.planes[face.plane];
  const Fine normal(plane.normal), way = Fine(plane.point) - Fine(ray.origin);
  const Quad slope = dot(normal, Fine(ray.direction));
  if (slope == 0 || (sides == Sides::front && slope > 0)) return {};
  const Quad t = dot(normal, way) / slope, passage = abs(Quad(plane.thickness) / slope);
  if (passage <= longest_passage * abs(t)) {
    return within(ray, meeting, t.convert_to<double>(), t == 0);
  }
  const Quad end = std::min(Quad(t + passage), exit_of_box(ray, vertices_of(scene, face)));
  return within(ray, meeting, end.convert_to<double>(), end == 0);
}

/// One of the two points where a ray passes an unbounded quadric.
struct Passage {
  Quad t;
  bool enters;
  bool sure;
};

/// Keeps the passages that the ray's interval and the side rule leave, up to the first sure one.
class Passages {
 public:
  Passages(const Ray& ray, Sides sides, bool inside_out)
      : ray_(ray), sides_(sides), inside_out_(inside_out) {}

  void add(const Passage& passage) {
    if (complete_ || (sides_ == Sides::front && passage.enters == inside_out_)) return;
    const Meeting meeting = passage.sure ? Meeting::interior : Meeting::undecided;
    const ExactHit hit = within(ray_, meeting, passage.t.convert_to<double>(), passage.t == 0);
    if (hit.meeting == Meeting::miss) return;
    hits_[count_++] = hit;
    complete_ = hit.meeting == Meeting::interior;
  }
  const ExactHits& hits() const { return hits_; }

 private:
  const Ray& ray_;
  Sides sides_;
  bool inside_out_, complete_ = false;
  ExactHits hits_;
  std::size_t count_ = 0;
};

/// Whether the line of the ray stays clear of a ball, as far as double can tell.
bool surely_passes_by(const Ray& ray, Vec3d centre, double radius) {
  const Vec3d d(ray.direction), f = centre - Vec3d(ray.origin);
  const Vec3d across = f - (glm::dot(f, d) / glm::dot(d, d)) * d;
  return glm::length(across) > (1.0 + 0x1p-20) * radius + 0x1p-40 * glm::length(f);
}

ExactHits meet_sphere(const Sphere& sphere, const Ray& ray, Sides sides) {
  if (surely_passes_by(ray, Vec3d(sphere.centre), std::abs(sphere.radius))) return {};
  using Fine = Vec3Of<Quad>;
  const Fine d(ray.direction), f = Fine(sphere.centre) - Fine(ray.origin);
  const Quad a = dot(d, d), middle = dot(f, d) / a;
  const Fine across = f - middle * d;
  const Quad r2 = Quad(sphere.radius) * Quad(sphere.radius);
  const Quad rest = r2 - dot(across, across);
  const bool sure = abs(rest) > two_ulp * r2;
  if (rest < 0 && sure) return {};
  const Quad half = sqrt(Quad(std::max(rest, Quad(0))) / a);
  Passages passages(ray, sides, sphere.radius < 0.0f);
  passages.add({middle - half, true, sure});
  passages.add({middle + half, false, sure});
  return passages.hits();
}

/// A cone in its own frame: position along the axis (0 base, 1 apex) and across it.
class ConeFrame {
 public:
  ConeFrame(const Cone& cone, const Ray& ray)
      : axis_(Fine(cone.apex) - Fine(cone.base)),
        length2_(dot(axis_, axis_)),
        radius_(abs(Quad(cone.base_radius))),
        growth_(abs(Quad(cone.apex_radius)) - radius_),
        inside_out_(cone.base_radius < 0.0f || cone.apex_radius < 0.0f) {
    const Fine d(ray.direction), f = Fine(ray.origin) - Fine(cone.base);
    // From the ray's point nearest to the base on, as far away nothing may cancel.
    shift_ = -dot(f, d) / dot(d, d);
    const Fine near = f + shift_ * d;
    at_ = dot(near, axis_) / length2_;
    step_ = dot(d, axis_) / length2_;
    const Fine p = near - at_ * axis_, q = d - step_ * axis_;
    const Quad r = radius_ + growth_ * at_, g = growth_ * step_;
    a_ = dot(q, q) - g * g;
    b_ = r * g - dot(p, q);
    c_ = dot(p, p) - r * r;
    size_ = abs(dot(p, p)) + r * r;
    steepness_ = dot(q, q) + g * g;
    const double far = glm::length(Vec3d(ray.origin) - Vec3d(cone.base));
    rim_ = two_ulp + 0x1p-44 * far / std::sqrt(length2_.convert_to<double>());
  }

  ExactHits meet(const Ray& ray, Sides sides) const {
    const Quad discriminant = b_ * b_ - a_ * c_;
    const bool sure = abs(discriminant) > two_ulp * (b_ * b_ + steepness_ * size_);
    if (discriminant < 0 && sure) return {};
    const Quad root = sqrt(Quad(std::max(discriminant, Quad(0))));
    const Quad q = b_ >= 0 ? b_ + root : b_ - root;
    Quad first = q == 0 ? Quad(0) : c_ / q;
    Quad second = a_ == 0 ? first : q / a_;
    if (first > second) std::swap(first, second);
    Passages passages(ray, sides, inside_out_);
    for (const Quad& t : {first, second}) {
      const Quad s = at_ + t * step_;
      if (s < -rim_ || s > 1 + rim_) continue;
      const bool inside = s > rim_ && s < 1 - rim_;
      // Where the ray enters, |across|^2 - radius^2 falls.
      passages.add({shift_ + t, a_ * t - b_ < 0, sure && inside});
    }
    return passages.hits();
  }

 private:
  using Fine = Vec3Of<Quad>;

  Fine axis_;
  Quad length2_, radius_, growth_;
  bool inside_out_;
  Quad shift_, at_, step_;
  Quad a_, b_, c_;         // a t^2 - 2 b t + c = 0, t from the shifted origin
  Quad size_, steepness_;  // magnitudes of the terms of c and a
  double rim_;             // half-width of the undecided band, in units of the axis
};

ExactHits meet_cone(const Cone& cone, const Ray& ray, Sides sides) {
  const Vec3d half = 0.5 * (Vec3d(cone.apex) - Vec3d(cone.base));
  const double widest = std::max(std::abs(cone.base_radius), std::abs(cone.apex_radius));
  if (surely_passes_by(ray, Vec3d(cone.base) + half, glm::length(half) + widest)) return {};
  return ConeFrame(cone, ray).meet(ray, sides);
}

}  // namespace

ExactHits exact_hits(const Scene& scene, std::uint32_t id, const Ray& ray, Sides sides) {
  if (!is_ray(ray) || is_degenerate(scene, id)) return {};
  const Object& object = scene.objects[id];
  switch (object.kind) {
    case ObjectKind::triangle:
      return {meet_triangle(scene, scene.faces[object.shape], ray, sides)};
    case ObjectKind::polygon:
      return {meet_polygon(scene, scene.faces[object.shape], ray, sides)};
    case ObjectKind::sphere:
      return meet_sphere(scene.spheres[object.shape], ray, sides);
    case ObjectKind::cone:
      break;
  }
  return meet_cone(scene.cones[object.shape], ray, sides);
}

}  // namespace bspview
