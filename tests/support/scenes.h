#pragma once

#include <cstdint>

#include "core/scene/scene.h"

namespace bspview::test {

/// `count` objects of every kind (triangles, concave polygons, patches, spheres, cones) in a cube
/// of side 2 around `centre`, with shiny, transparent and dull materials, two lights and a camera.
Scene random_scene(int count, std::uint64_t seed, Vec3 centre = Vec3(0.0f));

/// `count` triangles in the same cube.
Scene random_triangles(int count, std::uint64_t seed);

/// Axis-aligned cube surface of side 2, each side n x n squares of two triangles, around `centre`:
/// a closed mesh full of planar objects and shared edges.
Scene cube_grid(int n, Vec3 centre);

}  // namespace bspview::test
