#pragma once

#include <string>

#include "core/eval/stress/dice.h"
#include "core/scene/scene.h"

namespace bspview::stress {

inline constexpr int kind_count = 4;

/// Adds an object of that kind and about that size at `place`: a triangle, a concave star, a
/// sphere, a cone or cylinder.
void add_random(Scene& scene, ObjectKind kind, Vec3 place, float size, Dice& dice);

/// `count` objects of every kind in a cube of side 2 around `centre`.
Scene make_mixed_scene(int count, Vec3 centre, Dice& dice);

/// The same of triangles, spheres and cones alone.
Scene make_scene_without_polygons(int count, Vec3 centre, Dice& dice);

/// `count` triangles and squares in the plane where coordinate `axis` is `position`, in a square of
/// side 2; one object is a square that covers it all.
Scene make_coplanar_scene(int count, int axis, float position, Dice& dice);

/// The object's bits, to make it again.
std::string describe_object(const Scene& scene, std::uint32_t object);

}  // namespace bspview::stress
