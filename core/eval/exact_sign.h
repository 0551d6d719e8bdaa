#pragma once

// After Shewchuk 1997, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
// Predicates": the cheap number answers unless its own error bound forbids it. Here as a check of
// core/math/exact.h, of which it is independent: two filters, then integers.

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "core/math/vec.h"

namespace bspview {

/// 113 bits, as float128 has, on every machine.
using Quad = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_quad::backend_type,
                                           boost::multiprecision::et_off>;

/// Wide enough that sums of products of three differences of floats are never rounded: 837 bits.
using Unrounded = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<1024, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

template <class Number>
struct Vec3Of {
  Number x, y, z;

  explicit Vec3Of(Vec3 v) : x(v.x), y(v.y), z(v.z) {}
  explicit Vec3Of(Vec3d v) : x(v.x), y(v.y), z(v.z) {}
  Vec3Of(Number a, Number b, Number c) : x(a), y(b), z(c) {}

  const Number& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  friend Vec3Of operator-(const Vec3Of& a, const Vec3Of& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend Vec3Of operator+(const Vec3Of& a, const Vec3Of& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend Vec3Of operator*(const Number& s, const Vec3Of& v) { return {s * v.x, s * v.y, s * v.z}; }
};

template <class Number>
Number dot(const Vec3Of<Number>& a, const Vec3Of<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Number>
Vec3Of<Number> cross(const Vec3Of<Number>& a, const Vec3Of<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// A sum with the sum of the magnitudes of its terms, which bounds its error.
template <class Number>
struct Bounded {
  Number value, size;
};

/// Sign of a Bounded that `make` computes in the number type it is given; no term of it may have
/// gone through more than seven roundings.
template <class Make>
int certain_sign(const Make& make) {
  const Bounded<double> rough = make(double{});
  if (std::abs(rough.value) > 8.0 * 0x1p-53 * rough.size) return rough.value > 0.0 ? 1 : -1;
  const Bounded<Quad> fine = make(Quad{});
  if (abs(fine.value) > 8.0 * 0x1p-113 * fine.size) return fine.value > 0 ? 1 : -1;
  return make(Unrounded{}).value.sign();
}

}  // namespace bspview
