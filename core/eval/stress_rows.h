#pragma once

// The functions behind the table of stress_checks.cpp.

#include "core/eval/stress_check.h"

namespace bspview::stress {

Result<Trial> prepare_shared_edges(const Setting& setting);      // T04, stress_edges.cpp
Result<Trial> prepare_closed_meshes(const Setting& setting);     // T05, stress_leaks.cpp
Result<Trial> prepare_every_tree(const Setting& setting);        // T06, stress_leaks.cpp
Result<Trial> prepare_cube_grids(const Setting& setting);        // T07, stress_leaks.cpp
Result<Trial> prepare_rays_in_planes(const Setting& setting);    // T08, stress_planes.cpp
Result<Trial> prepare_coplanar_objects(const Setting& setting);  // T09, stress_coplanar.cpp
Result<Trial> prepare_no_rays(const Setting& setting);           // T18, stress_garbage.cpp

}  // namespace bspview::stress
