#pragma once

#include "core/render/surface.h"
#include "core/render/world.h"

namespace bspview::stress {

/// What the checks put to the test. The default is what pictures are made with; wrong variants show
/// that the checks can fail.
struct Subject {
  /// Nearest hit, with what it cost; in a world with an accelerator the cost stays 0.
  Hit (*closest)(const World&, const Ray&, RayCost&);
  /// Whether anything is hit.
  bool (*occluded)(const World&, const Ray&);
  /// One object alone; `all` is the box of everything in the scene.
  double (*shape)(const Scene&, std::uint32_t object, const Ray&, const Aabb& all);
  /// Twice the signed area of (0, p, q): the edge function.
  float (*edge)(Vec2 p, Vec2 q);
  Vec3 (*leaving)(const Surface&, Vec3d direction);
  Aabb (*bounds)(const Scene&, std::uint32_t object);
  Aabb (*clip)(std::span<const Vec3> vertices, const Aabb& cell);
};

/// Pictures in default settings.
const Subject& default_subject();

}  // namespace bspview::stress
