#pragma once

#include "core/math/strict_floats.h"
#include "core/math/vec.h"

namespace bspview {

/// Sign (-1, 0, 1) of det(d, a - o, b - o): on which side of the line through `o` along `d` the
/// line from a to b passes. Always right: double decides where its error bound allows, exact
/// arithmetic elsewhere. Every coordinate is finite.
int side_of_edge(Vec3 o, Vec3 d, Vec3 a, Vec3 b);

/// Sign of (a - o)[i] d[j] - (a - o)[j] d[i]: on which side of the line, seen along the third axis.
/// Always right, as above.
int side_of_line(Vec3 o, Vec3 d, Vec3 a, int i, int j);

/// Distance t, in units of `d`, at which the line o + t d meets the plane of a triangle, rounded
/// from its exact value. The line is not parallel to the plane.
double exact_plane_distance(Vec3 o, Vec3 d, const Vec3* triangle);

/// Sign of d . n for the exact normal n = (b - a) x (c - a) of a triangle.
int exact_slope_sign(Vec3 d, const Vec3* triangle);

}  // namespace bspview
