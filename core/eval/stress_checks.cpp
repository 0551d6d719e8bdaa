#include "core/eval/stress_rows.h"

namespace bspview::stress {
namespace {

constexpr Check table[] = {
    {"T04", "leaks", "neighbours see a shared edge from exactly opposite sides",
     prepare_shared_edges, 1'000'000},
    {"T05", "leaks", "every ray from inside a closed mesh hits it", prepare_closed_meshes, 900'000},
    {"T06", "leaks", "every tree finds what brute force finds on closed meshes", prepare_every_tree,
     1'000'000, 20'000},
    {"T07", "inplane", "every tree finds what brute force finds on cube grids", prepare_cube_grids,
     100'000},
    {"T08", "inplane", "26 directions from split planes, vertices and box faces",
     prepare_rays_in_planes, 10'000, 200},
    {"T09", "inplane", "coplanar objects and flat roots", prepare_coplanar_objects, 100'000},
    {"T18", "garbage", "what is no ray hits nothing and visits at most one node", prepare_no_rays,
     100'000},
};

}  // namespace

std::span<const Check> checks() {
  return table;
}

}  // namespace bspview::stress
