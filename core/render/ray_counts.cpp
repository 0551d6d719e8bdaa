#include "core/render/ray_counts.h"

namespace bspview {

RayCounts& RayCounts::operator+=(const RayCounts& other) {
  primary += other.primary;
  reflected += other.reflected;
  refracted += other.refracted;
  shadow += other.shadow;
  primary_hits += other.primary_hits;
  secondary_hits += other.secondary_hits;
  shadow_hits += other.shadow_hits;
  tests += other.tests;
  nodes_inner += other.nodes_inner;
  nodes_leaf += other.nodes_leaf;
  return *this;
}

void RayCounts::add_ray(RayKind kind, bool hit) {
  switch (kind) {
    case RayKind::primary:
      ++primary;
      primary_hits += hit;
      return;
    case RayKind::reflected:
      ++reflected;
      secondary_hits += hit;
      return;
    case RayKind::refracted:
      ++refracted;
      secondary_hits += hit;
      return;
    case RayKind::shadow:
      ++shadow;
      shadow_hits += hit;
      return;
  }
}

}  // namespace bspview
