#pragma once

// Wrong variants of what decides hits: each breaks one rule, and a check of the stress test must
// notice.

#include "core/eval/stress/subject.h"

namespace bspview::test {

/// The edge function with a fused multiply-add, which a compiler makes where contraction is on.
float contracted_edge(Vec2 p, Vec2 q);

/// Triangles after Woop, Benthin & Wald with that edge function: closed meshes have gaps.
stress::Subject contracted_woop();

/// Planes at one distance instead of an interval, strict comparisons.
stress::Subject single_distances();

/// Hits count only inside the cell where they are found.
stress::Subject hits_inside_cells();

/// Leaving rays start at the hit point, rounded to nearest.
stress::Subject no_offset();

/// Moeller & Trumbore in float.
stress::Subject float_triangles();

/// Spheres and cones by the textbook in float.
stress::Subject float_quadrics();

/// A root box test that lets NaN through, in a walk that takes planes at face value.
stress::Subject naive_slabs();

/// Boxes of objects, and of their clipped parts, rounded inwards.
stress::Subject boxes_rounded_inwards();

/// Any-hit that stops at the first leaf.
stress::Subject short_sighted_occlusion();

/// The traversals as they were published.
stress::Subject published(Traversal traversal);

}  // namespace bspview::test
