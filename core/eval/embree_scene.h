#pragma once

#include "core/scene/scene.h"

// Only for files that are compiled with BSPVIEW_EMBREE.
#include <embree3/rtcore.h>

#include <atomic>
#include <span>
#include <vector>

namespace bspview {

/// How Embree (Wald et al. 2014, "Embree: A Kernel Framework for Efficient CPU Ray Tracing") tests.
enum class EmbreeMode { standard, robust };

/// How it builds.
struct EmbreeBuild {
  int threads = 1;
  RTCBuildQuality quality = RTC_BUILD_QUALITY_HIGH;
};

/// Embree's copy of a scene: triangles, polygons cut into triangles, spheres as sphere points,
/// cones as linear cones without caps. Any number of threads may trace it.
class EmbreeScene {
 public:
  EmbreeScene(const Scene& scene, EmbreeMode mode, EmbreeBuild build = {});
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;
  ~EmbreeScene();

  RTCScene get() const { return scene_; }
  double build_seconds() const { return build_seconds_; }  ///< from its copy of the shapes on
  std::size_t bytes() const { return bytes_; }             ///< that the build allocated and kept

  /// The object behind an answer; no_index for RTC_INVALID_GEOMETRY_ID.
  std::uint32_t object(unsigned geometry, unsigned primitive) const {
    return geometry < objects_.size() ? objects_[geometry][primitive] : no_index;
  }

 private:
  /// Takes the geometry over; primitive i of it is objects[i].
  void attach(RTCGeometry geometry, std::vector<std::uint32_t> objects);
  void attach_faces(const Scene& scene);
  void attach_spheres(const Scene& scene);
  void attach_cones(const Scene& scene);

  RTCDevice device_;
  RTCScene scene_;
  std::vector<std::vector<std::uint32_t>> objects_;  // by geometry, then by primitive
  double build_seconds_ = 0.0;
  std::atomic<std::size_t> bytes_ = 0;
};

/// The ray as Embree takes it.
RTCRay embree_ray(const Ray& ray);

}  // namespace bspview
