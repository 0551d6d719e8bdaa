#pragma once

#include "core/eval/error/judge.h"

namespace bspview {

/// Lets rays leave the surfaces that the primary rays of a scene hit, by the offset rule of every
/// kernel; one result a kernel. A surface is left only where it cannot be met again: a face, or the
/// outside of a sphere or cone.
///
/// Acne: a ray from there in a random direction hits the same object.
/// Light leak: a shadow ray finds its light where the reference knows another object in its way,
/// farther from the surface than 16 ulp of the largest coordinate of the ray's origin.
std::vector<OffsetCounts> judge_offsets(const JudgedScene& scene,
                                        std::span<const BoundKernel> kernels, std::uint64_t seed);

/// The ray that leaves `hit` (of `ray`) towards `direction`: the fixed rule starts at the point as
/// float has it, the other at leaving_origin.
Ray leaving_ray(const Scene& scene, const Ray& ray, const RayResult& hit, OffsetRule rule,
                Vec3d direction);

}  // namespace bspview
