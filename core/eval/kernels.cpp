#include "core/eval/kernels.h"

#include <fmt/format.h>

#include <array>

#include "core/render/accelerator.h"
#include "core/render/hits.h"
#include "core/render/textbook_shapes.h"

namespace bspview {
namespace {

constexpr std::array<std::string_view, 4> face_tests{"float", "woop", "double", "exact"};
constexpr std::array<std::string_view, 2> quadric_tests{"float", "double"};

constexpr std::array<std::string_view, 4> face_sentences{
    "Moeller-Trumbore in float", "Woop in float", "Moeller-Trumbore in double", "exact faces"};

/// Nothing but the loop over the rays lies around the shape tests of the template.
template <class Shapes>
void set_functions(Kernel& kernel, Traversal traversal, float least_t) {
  const TraceRules rules{.traversal = traversal};
  kernel.closest = [=](const World& world) -> Kernel::Closest {
    return [=](std::span<const Ray> rays, std::span<RayResult> results) {
      NoObserver none;
      for (std::size_t i = 0; i < rays.size(); ++i) {
        Ray ray = rays[i];
        ray.t_min = std::max(ray.t_min, least_t);
        const Hit hit = closest_hit<Shapes>(world, ray, rules, none);
        results[i] = {hit.object, hit.t};
      }
    };
  };
  kernel.occluded = [=](const World& world) -> Kernel::Occluded {
    return [=](std::span<const Ray> rays, std::span<char> results) {
      NoObserver none;
      for (std::size_t i = 0; i < rays.size(); ++i) {
        Ray ray = rays[i];
        ray.t_min = std::max(ray.t_min, least_t);
        results[i] = any_hit<Shapes>(world, ray, rules, none) != no_index;
      }
    };
  };
}

template <class Faces>
void set_functions(Kernel& kernel, const KernelChoice& choice, float least_t) {
  if (choice.quadrics == QuadricTest::textbook_float) {
    set_functions<MixedShapes<Faces, FloatQuadrics>>(kernel, choice.traversal, least_t);
  } else {
    set_functions<MixedShapes<Faces, DoubleQuadrics>>(kernel, choice.traversal, least_t);
  }
}

}  // namespace

std::span<const std::string_view> face_test_names() {
  return face_tests;
}
std::span<const std::string_view> quadric_test_names() {
  return quadric_tests;
}
std::string_view name_of(FaceTest test) {
  return face_tests[static_cast<std::size_t>(test)];
}
std::string_view name_of(QuadricTest test) {
  return quadric_tests[static_cast<std::size_t>(test)];
}

Kernel make_kernel(const KernelChoice& choice) {
  const bool is_fixed = choice.offset == OffsetRule::fixed;
  const float least_t = is_fixed ? fixed_t_min : 0.0f;
  Kernel kernel;
  kernel.name = fmt::format("{}-{}-{}-{}", name_of(choice.faces), name_of(choice.quadrics),
                            name_of(choice.traversal), name_of(choice.offset));
  kernel.what =
      fmt::format("{}, quadrics in {}, traversal {}, {}",
                  face_sentences[static_cast<std::size_t>(choice.faces)], name_of(choice.quadrics),
                  name_of(choice.traversal), is_fixed ? "t_min = 1e-4" : "error-bounded offset");
  switch (choice.faces) {
    case FaceTest::moeller_float:
      set_functions<MoellerFaces<float>>(kernel, choice, least_t);
      return kernel;
    case FaceTest::woop_float:
      set_functions<WoopFaces>(kernel, choice, least_t);
      return kernel;
    case FaceTest::moeller_double:
      set_functions<MoellerFaces<double>>(kernel, choice, least_t);
      return kernel;
    case FaceTest::exact:
      break;
  }
  if (choice.quadrics == QuadricTest::in_double) {
    set_functions<ExactShapes>(kernel, choice.traversal, least_t);
  } else {
    set_functions<ExactFaces>(kernel, choice, least_t);
  }
  return kernel;
}

Kernel make_fast_kernel() {
  Kernel kernel;
  kernel.name = "bspview";
  kernel.what = fmt::format("the default: exact, wide tree, one ray ({})", packet_instructions());
  kernel.closest = [](const World& world) -> Kernel::Closest {
    return [fast = FastWorld(world)](std::span<const Ray> rays, std::span<RayResult> results) {
      for (std::size_t i = 0; i < rays.size(); ++i) {
        const Hit hit = fast_closest_hit(fast.world(), rays[i], SideRule::two_sided);
        results[i] = {hit.object, hit.t};
      }
    };
  };
  kernel.occluded = [](const World& world) -> Kernel::Occluded {
    return [fast = FastWorld(world)](std::span<const Ray> rays, std::span<char> results) {
      for (std::size_t i = 0; i < rays.size(); ++i) {
        results[i] = fast_any_hit(fast.world(), rays[i], SideRule::two_sided) != no_index;
      }
    };
  };
  return kernel;
}

}  // namespace bspview
