#include "core/eval/error/embree_kernel.h"

#ifdef BSPVIEW_EMBREE
#include <embree3/rtcore.h>

#include <memory>
#endif

namespace bspview {

#ifdef BSPVIEW_EMBREE
namespace {

/// Embree's copy of a scene of triangles; triangle i is object i.
class EmbreeScene {
 public:
  EmbreeScene(const Scene& scene, RTCSceneFlags flags)
      : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    rtcSetSceneFlags(scene_, flags);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    RTCGeometry mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    const std::size_t count = scene.objects.size();
    auto* vertices = static_cast<Vec3*>(rtcSetNewGeometryBuffer(
        mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3), 3 * count));
    auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), count));
    for (std::size_t i = 0; i < count; ++i) {
      const auto corners = vertices_of(scene, scene.faces[scene.objects[i].shape]);
      for (std::size_t k = 0; k < 3; ++k) {
        vertices[3 * i + k] = corners[k];
        indices[3 * i + k] = static_cast<unsigned>(3 * i + k);
      }
    }
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(scene_, mesh);
    rtcReleaseGeometry(mesh);
    rtcCommitScene(scene_);
  }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;
  ~EmbreeScene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  RayResult closest(const Ray& ray, RTCIntersectContext& context) const {
    RTCRayHit query{};
    query.ray = make_ray(ray);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return {query.hit.primID, query.ray.tfar};
  }
  bool occluded(const Ray& ray, RTCIntersectContext& context) const {
    RTCRay query = make_ray(ray);
    rtcOccluded1(scene_, &context, &query);
    return query.tfar < 0.0f;
  }

 private:
  static RTCRay make_ray(const Ray& ray) {
    RTCRay query{};
    query.org_x = ray.origin.x;
    query.org_y = ray.origin.y;
    query.org_z = ray.origin.z;
    query.dir_x = ray.direction.x;
    query.dir_y = ray.direction.y;
    query.dir_z = ray.direction.z;
    query.tnear = ray.t_min;
    query.tfar = ray.t_max;
    query.mask = ~0u;
    return query;
  }

  RTCDevice device_;
  RTCScene scene_;
};

ErrorConfig embree_config(const std::string& name, const std::string& mode, RTCSceneFlags flags) {
  ErrorConfig config;
  config.name = name;
  config.what = "Embree " RTC_VERSION_STRING ", " + mode;
  config.kernel.name = name;
  config.kernel.what = config.what;
  config.kernel.closest = [flags](const World& world) -> Kernel::Closest {
    const auto scene = std::make_shared<EmbreeScene>(world.scene, flags);
    return [scene](std::span<const Ray> rays, std::span<RayResult> results) {
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      for (std::size_t i = 0; i < rays.size(); ++i) results[i] = scene->closest(rays[i], context);
    };
  };
  config.kernel.occluded = [flags](const World& world) -> Kernel::Occluded {
    const auto scene = std::make_shared<EmbreeScene>(world.scene, flags);
    return [scene](std::span<const Ray> rays, std::span<char> results) {
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      for (std::size_t i = 0; i < rays.size(); ++i) results[i] = scene->occluded(rays[i], context);
    };
  };
  return config;
}

}  // namespace

std::vector<ErrorConfig> embree_configs() {
  return {embree_config("Embree", "default mode", RTC_SCENE_FLAG_NONE),
          embree_config("Embree robust", "robust mode", RTC_SCENE_FLAG_ROBUST)};
}
#else
std::vector<ErrorConfig> embree_configs() {
  return {};
}
#endif

}  // namespace bspview
