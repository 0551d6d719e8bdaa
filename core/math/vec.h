#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace bspview {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec3d = glm::dvec3;

/// v[axis] for an axis that the compiler does not know: one load, where glm branches.
inline float component(const Vec3& v, int axis) {
  return glm::value_ptr(v)[axis];
}

/// glm::abs, which branches on every sign.
template <class Scalar>
glm::vec<3, Scalar> magnitudes(glm::vec<3, Scalar> v) {
  return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}

inline double sum_of_magnitudes(Vec3d v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

inline float largest_component(Vec3 v) {
  return std::max({v.x, v.y, v.z});
}

}  // namespace bspview
