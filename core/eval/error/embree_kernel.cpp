#include "core/eval/error/embree_kernel.h"

#ifdef BSPVIEW_EMBREE
#include <memory>

#include "core/eval/embree_scene.h"
#endif

namespace bspview {

#ifdef BSPVIEW_EMBREE
namespace {

RayResult closest(const EmbreeScene& scene, const Ray& ray, RTCIntersectContext& context) {
  RTCRayHit query{};
  query.ray = embree_ray(ray);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene.get(), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return {query.hit.primID, query.ray.tfar};  // triangle i is object i
}

bool occluded(const EmbreeScene& scene, const Ray& ray, RTCIntersectContext& context) {
  RTCRay query = embree_ray(ray);
  rtcOccluded1(scene.get(), &context, &query);
  return query.tfar < 0.0f;
}

ErrorConfig embree_config(const std::string& name, const std::string& what, EmbreeMode mode) {
  ErrorConfig config;
  config.name = name;
  config.what = "Embree " RTC_VERSION_STRING ", " + what;
  config.kernel.name = name;
  config.kernel.what = config.what;
  config.kernel.closest = [mode](const World& world) -> Kernel::Closest {
    const auto scene = std::make_shared<EmbreeScene>(world.scene, mode);
    return [scene](std::span<const Ray> rays, std::span<RayResult> results) {
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      for (std::size_t i = 0; i < rays.size(); ++i) results[i] = closest(*scene, rays[i], context);
    };
  };
  config.kernel.occluded = [mode](const World& world) -> Kernel::Occluded {
    const auto scene = std::make_shared<EmbreeScene>(world.scene, mode);
    return [scene](std::span<const Ray> rays, std::span<char> results) {
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      for (std::size_t i = 0; i < rays.size(); ++i) results[i] = occluded(*scene, rays[i], context);
    };
  };
  return config;
}

}  // namespace

std::vector<ErrorConfig> embree_configs() {
  return {embree_config("Embree", "default mode", EmbreeMode::standard),
          embree_config("Embree robust", "robust mode", EmbreeMode::robust)};
}
#else
std::vector<ErrorConfig> embree_configs() {
  return {};
}
#endif

}  // namespace bspview
