// After Shewchuk 1997, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
// Predicates": the cheap evaluation answers unless its own error bound forbids it.

#include "core/math/exact.h"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

namespace bspview {
namespace {

/// A float has 24 bits between 2^-149 and 2^128. A difference of two fits into 278 bits, a product
/// of three differences into 834 and a sum of six of those into 837: nothing is ever rounded.
using Exact = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<900, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

struct ExactVec {
  Exact x, y, z;
};

ExactVec exact(Vec3 v) {
  return {Exact(v.x), Exact(v.y), Exact(v.z)};
}
ExactVec difference(Vec3 a, Vec3 b) {
  return {Exact(a.x) - Exact(b.x), Exact(a.y) - Exact(b.y), Exact(a.z) - Exact(b.z)};
}
ExactVec cross(const ExactVec& a, const ExactVec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Exact dot(const ExactVec& a, const ExactVec& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

ExactVec exact_normal(const Vec3* triangle) {
  return cross(difference(triangle[1], triangle[0]), difference(triangle[2], triangle[0]));
}

}  // namespace

int side_of_edge(Vec3 o, Vec3 d, Vec3 a, Vec3 b) {
  const Vec3d from = Vec3d(a) - Vec3d(o), to = Vec3d(b) - Vec3d(o);
  const auto minor = [&](int i, int j) { return from[i] * to[j] - from[j] * to[i]; };
  const auto size = [&](int i, int j) {
    return std::abs(from[i] * to[j]) + std::abs(from[j] * to[i]);
  };
  const double det = d.x * minor(1, 2) + d.y * minor(2, 0) + d.z * minor(0, 1);
  // At most seven roundings lie on the way from the coordinates to any term of the sum.
  const double bound =
      8.0 * 0x1p-53 *
      (std::abs(d.x) * size(1, 2) + std::abs(d.y) * size(2, 0) + std::abs(d.z) * size(0, 1));
  if (det > bound) return 1;
  if (det < -bound) return -1;
  return dot(exact(d), cross(difference(a, o), difference(b, o))).sign();
}

int side_of_line(Vec3 o, Vec3 d, Vec3 a, int i, int j) {
  const double first = (static_cast<double>(a[i]) - o[i]) * d[j];
  const double second = (static_cast<double>(a[j]) - o[j]) * d[i];
  const double minor = first - second;
  const double bound = 4.0 * 0x1p-53 * (std::abs(first) + std::abs(second));
  if (minor > bound) return 1;
  if (minor < -bound) return -1;
  const Exact exact_first = (Exact(a[i]) - Exact(o[i])) * Exact(d[j]);
  return (exact_first - (Exact(a[j]) - Exact(o[j])) * Exact(d[i])).sign();
}

double exact_plane_distance(Vec3 o, Vec3 d, const Vec3* triangle) {
  const ExactVec normal = exact_normal(triangle);
  const Exact t = dot(normal, difference(triangle[0], o)) / dot(normal, exact(d));
  return t.convert_to<double>();
}

int exact_slope_sign(Vec3 d, const Vec3* triangle) {
  return dot(exact_normal(triangle), exact(d)).sign();
}

}  // namespace bspview
