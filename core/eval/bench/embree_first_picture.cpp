#include "core/eval/bench/first_picture.h"

#ifdef BSPVIEW_EMBREE
#include <algorithm>

#include "core/base/parallel.h"
#include "core/base/timer.h"
#include "core/eval/embree_scene.h"
#endif

namespace bspview {

#ifdef BSPVIEW_EMBREE
namespace {

constexpr std::size_t packet_size = 8;

RTCIntersectContext context_with(RTCIntersectContextFlags flags) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = flags;
  return context;
}

/// The rays of one picture.
class EmbreeRays {
 public:
  explicit EmbreeRays(const EmbreeScene& scene) : scene_(scene) {}

  void eye_hits(std::span<const Ray> rays, std::span<Hit> hits) const {
    for (std::size_t i = 0; i < rays.size(); i += packet_size) {
      const std::size_t count = std::min(packet_size, rays.size() - i);
      packet(rays.subspan(i, count), hits.subspan(i, count));
    }
  }

  Hit closest(const Ray& ray) const {
    RTCIntersectContext context = context_with(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
    RTCRayHit query{};
    query.ray = embree_ray(ray);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_.get(), &context, &query);
    return hit(query.hit.geomID, query.hit.primID, query.ray.tfar);
  }

  bool is_occluded(const Ray& ray) const {
    RTCIntersectContext context = context_with(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
    RTCRay query = embree_ray(ray);
    rtcOccluded1(scene_.get(), &context, &query);
    return query.tfar < 0.0f;  // -inf
  }

 private:
  void packet(std::span<const Ray> rays, std::span<Hit> hits) const {
    RTCIntersectContext context = context_with(RTC_INTERSECT_CONTEXT_FLAG_COHERENT);
    alignas(32) int valid[packet_size] = {};
    RTCRayHit8 query{};
    for (std::size_t k = 0; k < rays.size(); ++k) {
      const RTCRay ray = embree_ray(rays[k]);
      valid[k] = -1;
      query.ray.org_x[k] = ray.org_x;
      query.ray.org_y[k] = ray.org_y;
      query.ray.org_z[k] = ray.org_z;
      query.ray.dir_x[k] = ray.dir_x;
      query.ray.dir_y[k] = ray.dir_y;
      query.ray.dir_z[k] = ray.dir_z;
      query.ray.tnear[k] = ray.tnear;
      query.ray.tfar[k] = ray.tfar;
      query.ray.mask[k] = ray.mask;
      query.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect8(valid, scene_.get(), &context, &query);
    for (std::size_t k = 0; k < rays.size(); ++k) {
      hits[k] = hit(query.hit.geomID[k], query.hit.primID[k], query.ray.tfar[k]);
    }
  }

  Hit hit(unsigned geometry, unsigned primitive, float t) const {
    const std::uint32_t object = scene_.object(geometry, primitive);
    return object == no_index ? Hit{} : Hit{t, object, no_leaf};
  }

  const EmbreeScene& scene_;
};

Result<FirstPictureSeconds> time_embree(const Scene& scene, const RenderParams& picture,
                                        std::stop_token stop) {
  const EmbreeScene built(scene, EmbreeMode::robust,
                          {thread_count(picture.threads), RTC_BUILD_QUALITY_MEDIUM});
  const EmbreeRays rays(built);
  const RayKernel kernel{.eye_hits = [&](auto some, auto hits) { rays.eye_hits(some, hits); },
                         .closest = [&](const Ray& ray) { return rays.closest(ray); },
                         .is_occluded = [&](const Ray& ray) { return rays.is_occluded(ray); }};
  const Timer timer;
  const auto image = render_with(scene, kernel, scene.camera, picture, stop);
  if (!image) return image.error();
  return FirstPictureSeconds{built.build_seconds(), timer.seconds()};
}

}  // namespace

std::vector<FirstPicturePeer> embree_first_pictures() {
  return {{"Embree",
           "Embree " RTC_VERSION_STRING
           ", its tree of boxes at medium quality, robust mode, with our shading; eye rays by 8",
           true, time_embree}};
}
#else
std::vector<FirstPicturePeer> embree_first_pictures() {
  return {};
}
#endif

}  // namespace bspview
