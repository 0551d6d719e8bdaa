#pragma once

#include <cstdint>

#include "app/viewer/overlays/line_list.h"
#include "core/scene/scene.h"

namespace bspview {

/// Adds lines like `pen` (its colour and width) along the outline of an object: the edges of a
/// polygon, three great circles of a sphere, both rims and four generators of a cone.
void add_wireframe(LineList& lines, const Scene& scene, std::uint32_t object, Line pen);

}  // namespace bspview
