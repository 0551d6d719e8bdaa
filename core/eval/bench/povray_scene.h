#pragma once

#include <string>

#include "core/scene/scene.h"

namespace bspview {

/// The scene in the language of POV-Ray 3.7 with what pictures here show: Phong highlights,
/// shadows, reflection and refraction, at most `max_ray_depth` levels of rays. Degenerate objects
/// are left out.
std::string to_povray(const Scene& scene, int max_ray_depth);

}  // namespace bspview
