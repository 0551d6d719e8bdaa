#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/math/aabb.h"

namespace bspview {

// Numbers as the panels write them: short, with units.

std::string with_thousands(std::uint64_t number);   ///< "1 402 297"
std::string significant(double value, int digits);  ///< "12.3", "0.00412"; no exponent below 1e15
std::string duration(double seconds);               ///< "43.1 ms", "1.24 s", "3 min 20 s"
std::string memory(double bytes);                   ///< "3.4 MiB"
std::string point(Vec3 p);                          ///< "(1.5, 0, -2)"
/// "12 leaves", "1 leaf".
std::string counted(std::uint64_t number, const char* singular, const char* plural);

/// How a number changed: "+12 %", "−3.1 %", "×4.2" from a factor of two upwards, "=" when equal.
std::string change(double before, double now);

}  // namespace bspview
