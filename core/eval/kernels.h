#pragma once

#include <span>
#include <string_view>

#include "core/bsp/traversal.h"
#include "core/eval/kernel.h"
#include "core/render/arithmetic.h"

namespace bspview {

/// Arithmetic of triangles and polygons.
enum class FaceTest { moeller_float, woop_float, moeller_double, exact };
/// Arithmetic of spheres, cones and cylinders.
enum class QuadricTest { textbook_float, in_double };
/// Names for people and files, in the order of the enumerators.
std::span<const std::string_view> face_test_names();
std::span<const std::string_view> quadric_test_names();
std::string_view name_of(FaceTest test);
std::string_view name_of(QuadricTest test);

/// What of tracing a ray decides about its errors and its speed; the default is that of pictures.
struct KernelChoice {
  FaceTest faces = FaceTest::exact;
  QuadricTest quadrics = QuadricTest::in_double;
  Traversal traversal = Traversal::robust;
  OffsetRule offset = OffsetRule::error_bounded;
  bool operator==(const KernelChoice&) const = default;
};

/// The kernel of a choice. It sees both sides of everything, on the calling thread.
Kernel make_kernel(const KernelChoice& choice);

/// The answers of the default choice by the wide tree, one ray at a time, see core/render/hits.h.
Kernel make_fast_kernel();

}  // namespace bspview
