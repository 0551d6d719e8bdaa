#pragma once

// The functions behind the table of stress_checks.cpp.

#include "core/eval/stress_check.h"

namespace bspview::stress {

Result<Trial> prepare_aimed_triangles(const Setting& setting);   // T01, stress_triangles.cpp
Result<Trial> prepare_triangle_sizes(const Setting& setting);    // T02, stress_triangles.cpp
Result<Trial> prepare_flat_triangles(const Setting& setting);    // T03, stress_triangles.cpp
Result<Trial> prepare_shared_edges(const Setting& setting);      // T04, stress_edges.cpp
Result<Trial> prepare_closed_meshes(const Setting& setting);     // T05, stress_leaks.cpp
Result<Trial> prepare_every_tree(const Setting& setting);        // T06, stress_leaks.cpp
Result<Trial> prepare_cube_grids(const Setting& setting);        // T07, stress_leaks.cpp
Result<Trial> prepare_rays_in_planes(const Setting& setting);    // T08, stress_planes.cpp
Result<Trial> prepare_coplanar_objects(const Setting& setting);  // T09, stress_coplanar.cpp
Result<Trial> prepare_exact_clipping(const Setting& setting);    // T10, stress_clip.cpp
Result<Trial> prepare_close_events(const Setting& setting);      // T11, stress_trees.cpp
Result<Trial> prepare_hard_builds(const Setting& setting);       // T12, stress_trees.cpp
Result<Trial> prepare_leaving_rays(const Setting& setting);      // T14, stress_leaving.cpp
Result<Trial> prepare_narrow_gaps(const Setting& setting);       // T15, stress_leaving.cpp
Result<Trial> prepare_points_in_boxes(const Setting& setting);   // T16, stress_clip.cpp
Result<Trial> prepare_wild_scenes(const Setting& setting);       // T17, stress_garbage.cpp
Result<Trial> prepare_no_rays(const Setting& setting);           // T18, stress_garbage.cpp
Result<Trial> prepare_far_quadrics(const Setting& setting);      // T19, stress_quadrics.cpp
Result<Trial> prepare_occlusion(const Setting& setting);         // T20, stress_occlusion.cpp
Result<Trial> prepare_threads(const Setting& setting);           // T21, stress_threads.cpp
Result<Trial> prepare_stops(const Setting& setting);             // T22, stress_stops.cpp

}  // namespace bspview::stress
