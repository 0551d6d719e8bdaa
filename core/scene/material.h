#pragma once

#include "core/math/vec.h"

namespace bspview {

/// Surface after the `f` record of NFF: colour, then Kd, Ks, Phong exponent, T, index of refraction.
struct Material {
  Vec3 color{1.0f};
  float diffuse = 1.0f;
  float specular = 0.0f;
  float shine = 0.0f;
  float transmittance = 0.0f;
  float refraction_index = 1.0f;

  bool operator==(const Material&) const = default;
};

}  // namespace bspview
