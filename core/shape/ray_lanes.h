#pragma once

#include "core/shape/ray_query.h"

namespace bspview {

/// Rays side by side for the lanes of vector instructions. Their directions have their largest
/// component on the same axis.
struct alignas(64) RayLanes {
  static constexpr int most = 16;

  float origin[3][most], direction[3][most];
  float t_min[most], t_max[most];
  float length[most];                  ///< of the directions
  float shear_x[most], shear_y[most];  ///< as in RayQuery
  int kx, ky, kz;
  float reach_error;    ///< of the farthest-reaching
  unsigned active = 0;  ///< one bit a lane

  Ray ray(int lane) const {
    return {{origin[0][lane], origin[1][lane], origin[2][lane]},
            {direction[0][lane], direction[1][lane], direction[2][lane]},
            t_min[lane],
            t_max[lane]};
  }
};

}  // namespace bspview
