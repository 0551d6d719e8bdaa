#pragma once

#include <span>
#include <string_view>

namespace bspview {

/// Arithmetic of the tests that decide what a picture shows, the roughest first.
enum class Arithmetic {
  textbook,   ///< float: Moeller & Trumbore, crossings, the quadratic formula
  woop,       ///< the same with triangles after Woop, Benthin & Wald, watertight in float
  in_double,  ///< Moeller & Trumbore and crossings in double, quadrics as in `exact`
  exact       ///< faces as exact arithmetic decides, quadrics in double
};

/// How a ray is kept from hitting the surface that it leaves.
enum class OffsetRule {
  fixed,         ///< it starts at the rounded hit point and ignores t below fixed_t_min
  error_bounded  ///< it starts off the surface by the error of the hit point (leaving_origin)
};

/// The usual constant of textbooks, in units of the ray's direction.
inline constexpr float fixed_t_min = 1e-4f;

/// Names as on the command line, in the order of the enumerators.
std::span<const std::string_view> arithmetic_names();
std::span<const std::string_view> offset_rule_names();
std::string_view name_of(Arithmetic arithmetic);
std::string_view name_of(OffsetRule rule);

}  // namespace bspview
