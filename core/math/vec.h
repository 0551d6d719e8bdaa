#pragma once

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace bspview {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec3d = glm::dvec3;

inline float largest_component(Vec3 v) { return std::max({v.x, v.y, v.z}); }

}  // namespace bspview
