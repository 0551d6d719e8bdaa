#pragma once

#include "core/math/aabb.h"
#include "core/scene/camera.h"
#include "core/scene/light.h"

namespace bspview {

/// View for a scene that has none: z is up, as in the standard scenes, and the box fills the
/// picture, seen from the front right and above.
Camera make_default_view(const Aabb& bounds);

/// Light for a scene that has none: white, above and to the left of the eye, so that surfaces that
/// face the eye are lit and their shadows are seen.
Light make_default_light(const Camera& camera);

}  // namespace bspview
