#include "core/eval/stress/rows.h"

namespace bspview::stress {
namespace {

constexpr Check table[] = {
    {"T01", "triangles", "triangles hit inside are right within 16 ulp", prepare_aimed_triangles,
     100'000},
    {"T02", "triangles", "edges of 1e-8 to 1e8 are hit", prepare_triangle_sizes, 100'000},
    {"T03", "triangles", "triangles without area are missed", prepare_flat_triangles, 10'000},
    {"T04", "leaks", "neighbours see a shared edge from exactly opposite sides",
     prepare_shared_edges, 1'000'000},
    {"T05", "leaks", "every ray from inside a closed mesh hits it", prepare_closed_meshes, 900'000},
    {"T06", "leaks", "every tree finds what brute force and exact arithmetic find",
     prepare_every_tree, 1'000'000, 20'000},
    {"T07", "inplane", "every tree finds what brute force finds on cube grids", prepare_cube_grids,
     100'000},
    {"T08", "inplane", "26 directions from split planes, vertices and box faces",
     prepare_rays_in_planes, 10'000, 200},
    {"T09", "inplane", "coplanar objects and flat roots", prepare_coplanar_objects, 100'000},
    {"T10", "build", "the box of a clipped triangle holds the exact part", prepare_exact_clipping,
     1'000'000},
    {"T11", "build", "bounds one float apart: counts are classifications, trees are valid",
     prepare_close_events, 10'000},
    {"T12", "build", "100,000 hard objects, any depth asked for: the tree stays bounded",
     prepare_hard_builds, 54},
    {"T14", "leaving", "a leaving ray never meets its own surface again", prepare_leaving_rays,
     40'000, 10'000},
    {"T15", "leaving", "a surface closely behind another is found", prepare_narrow_gaps, 100'000},
    {"T16", "build", "points of every surface lie in its box", prepare_points_in_boxes, 1'000'000,
     100'000},
    {"T17", "garbage", "objects of random bits harm nobody and are hit where that is defined",
     prepare_wild_scenes, 1000},
    {"T18", "garbage", "what is no ray hits nothing and visits at most one node", prepare_no_rays,
     100'000},
    {"T19", "far", "spheres and cones 1e6 radii away and at tangents are as in float128",
     prepare_far_quadrics, 400'000},
    {"T20", "anyhit", "a ray is occluded exactly when it hits something", prepare_occlusion,
     1'000'000, 50'000},
    {"T21", "threads", "pictures and counts are the same on any number of threads", prepare_threads,
     104, 4, true},
    {"T22", "stops", "a stop at any moment is obeyed at once and harms nothing", prepare_stops, 300,
     0, true},
};

}  // namespace

std::span<const Check> checks() {
  return table;
}

}  // namespace bspview::stress
