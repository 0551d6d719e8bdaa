#pragma once

// The functions behind the table of checks.cpp.

#include "core/eval/stress/check.h"

namespace bspview::stress {

Result<Trial> prepare_aimed_triangles(const Setting& setting);   // T01, triangles.cpp
Result<Trial> prepare_triangle_sizes(const Setting& setting);    // T02, triangles.cpp
Result<Trial> prepare_flat_triangles(const Setting& setting);    // T03, triangles.cpp
Result<Trial> prepare_shared_edges(const Setting& setting);      // T04, edges.cpp
Result<Trial> prepare_closed_meshes(const Setting& setting);     // T05, leaks.cpp
Result<Trial> prepare_every_tree(const Setting& setting);        // T06, leaks.cpp
Result<Trial> prepare_cube_grids(const Setting& setting);        // T07, leaks.cpp
Result<Trial> prepare_rays_in_planes(const Setting& setting);    // T08, planes.cpp
Result<Trial> prepare_coplanar_objects(const Setting& setting);  // T09, coplanar.cpp
Result<Trial> prepare_exact_clipping(const Setting& setting);    // T10, clip.cpp
Result<Trial> prepare_close_events(const Setting& setting);      // T11, trees.cpp
Result<Trial> prepare_hard_builds(const Setting& setting);       // T12, trees.cpp
Result<Trial> prepare_leaving_rays(const Setting& setting);      // T14, leaving.cpp
Result<Trial> prepare_narrow_gaps(const Setting& setting);       // T15, leaving.cpp
Result<Trial> prepare_points_in_boxes(const Setting& setting);   // T16, clip.cpp
Result<Trial> prepare_wild_scenes(const Setting& setting);       // T17, wild.cpp
Result<Trial> prepare_no_rays(const Setting& setting);           // T18, garbage.cpp
Result<Trial> prepare_far_quadrics(const Setting& setting);      // T19, quadrics.cpp
Result<Trial> prepare_occlusion(const Setting& setting);         // T20, occlusion.cpp
Result<Trial> prepare_threads(const Setting& setting);           // T21, threads.cpp
Result<Trial> prepare_stops(const Setting& setting);             // T22, stops.cpp

}  // namespace bspview::stress
