#pragma once

#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/base/watch.h"
#include "core/bsp/ray_log.h"
#include "core/bsp/traversal.h"
#include "core/render/arithmetic.h"
#include "core/render/intersect.h"
#include "core/render/ray_counts.h"
#include "core/render/world.h"

namespace bspview {

/// How a picture is made; compares by value.
struct RenderParams {
  int width = 512, height = 512;  ///< pixels
  int samples = 1;                ///< rays a pixel; with spd_rules: corner rays, samples ignored
  int max_ray_depth = 5;          ///< levels of rays, the eye ray being level 1
  bool spd_rules = false;         ///< corner rays, one-sided objects, every ray shot: cutoff and
                                  ///< adaptive are ignored
  Traversal traversal = Traversal::robust;
  Arithmetic arithmetic = Arithmetic::exact;
  OffsetRule offset = OffsetRule::error_bounded;
  int threads = 0;  ///< 0: every core; never changes the picture
  /// Reflected, refracted and shadow rays are not shot where they count for less. See shade.h.
  float cutoff = 0.0f;
  /// A pixel gets no more samples once its error is estimated below it; 0: every pixel gets
  /// `samples`. See adaptive.h.
  float adaptive = 0.0f;

  bool operator==(const RenderParams&) const = default;
};

/// Row-major picture, top row first.
struct Image {
  int width = 0, height = 0;
  std::vector<Vec3> pixels;  ///< display-referred, 1 is white; not clamped
  bool operator==(const Image&) const = default;
};

/// One complete picture, with nothing counted: the timed path.
/// Fails with the error "stopped" when a stop was requested, and when memory runs out.
Result<Image> render_image(const World& world, const Camera& camera, const RenderParams& params,
                           const Watch& watch = {});

/// The same picture, bit for bit, with what its rays cost.
struct CountedImage {
  Image image;
  RayCounts counts;
};
Result<CountedImage> render_counted(const World& world, const Camera& camera,
                                    const RenderParams& params, const Watch& watch = {});

/// What else can answer the rays of a picture, from several threads; see PlainTracer.
struct RayKernel {
  std::function<void(std::span<const Ray>, std::span<Hit>)> eye_hits;
  std::function<Hit(const Ray&)> closest;
  std::function<bool(const Ray&)> is_occluded;
};
Result<Image> render_with(const Scene& scene, const RayKernel& kernel, const Camera& camera,
                          const RenderParams& params, const Watch& watch = {});

/// The same picture by brute force in double precision, without a tree.
Result<Image> render_reference(const Scene& scene, const Camera& camera, const RenderParams& params,
                               const Watch& watch = {});

/// State of a progressive picture. Buffers have width x height entries, row-major, top row first.
struct Frame {
  int width = 0, height = 0;
  std::vector<Vec3> color;            ///< mean of the samples so far
  std::vector<float> distance;        ///< t of the first hit of the pixel-centre ray; inf: none
  std::vector<std::uint32_t> object;  ///< its object; no_index: none
  std::vector<std::uint32_t> leaf;    ///< node index of the leaf where it was found; no_leaf: none
  int pass = 0, pass_count = 0;       ///< done and planned; pass == pass_count: converged. Planned
                                      ///< are fewer as soon as adaptive sampling needs no more
  double seconds = 0.0;               ///< since the start of the picture, making ready included
  RayCounts counts;                   ///< of the first pass with one sample in every pixel
  bool counted = false;               ///< that pass is done: counts are those of one ray a pixel
};

/// What a progressive picture is traced against. Passes that count walk the binary tree of
/// `counted`; those after them go through what `fast` answers, which is asked once, before the
/// first of them. Null: through `counted`.
struct ProgressiveWorlds {
  World counted;
  std::function<World()> fast = nullptr;
  /// First of all comes a frame of pass 0: what the eye rays of the first pass hit, with no
  /// colours.
  bool looks_first = false;
};

/// Passes with a ray in every 8th, 4th, 2nd and every pixel in both directions, then one more
/// sample in every pass, in every pixel that lives, until params.samples. Calls publish(frame)
/// after each pass, on the calling thread; returns when converged or when `stop` is requested
/// (polled per tile). The converged picture is that of render_image.
void render_progressive(const ProgressiveWorlds& worlds, const Camera& camera,
                        const RenderParams& params, std::stop_token stop,
                        const std::function<void(const Frame&)>& publish);
inline void render_progressive(const World& world, const Camera& camera, const RenderParams& params,
                               std::stop_token stop,
                               const std::function<void(const Frame&)>& publish) {
  render_progressive(ProgressiveWorlds{world}, camera, params, std::move(stop), publish);
}

/// One ray of the tree of rays behind a pixel.
struct PathRay {
  RayKind kind = RayKind::primary;
  int level = 1;    ///< 1: eye ray
  int parent = -1;  ///< index of the ray whose hit sent it; -1: none
  Ray ray;
  std::uint32_t object = no_index;  ///< what it hit (shadow: what blocked it)
  double t = 0.0;                   ///< of the hit
  RayLog log;
};

/// Every ray that the ray through (x, y) (pixel coordinates, see PrimaryRays) leads to, each with
/// its walk through the tree; element 0 is the eye ray, parents come first.
std::vector<PathRay> trace_pixel(const World& world, const Camera& camera,
                                 const RenderParams& params, Vec2 pixel);

}  // namespace bspview
