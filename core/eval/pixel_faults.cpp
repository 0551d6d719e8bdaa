#include "core/eval/pixel_faults.h"

#include <algorithm>
#include <array>

#include "core/base/parallel.h"
#include "core/render/pixel_grid.h"
#include "core/render/surface.h"
#include "core/render/trace.h"

namespace bspview {
namespace {

/// Distance of the pixels checked in each pass, in both directions. The first divides a tile.
constexpr std::array<int, 5> strides{16, 8, 4, 2, 1};

class FaultFinder {
 public:
  explicit FaultFinder(const JudgedPicture& picture)
      : world_(picture.world),
        reference_(picture.reference),
        params_(picture.params),
        rules_(trace_rules(params_)),
        eye_(picture.camera, params_.width, params_.height) {
    faults_.width = params_.width;
    faults_.height = params_.height;
    faults_.pixels.assign(static_cast<std::size_t>(params_.width) * params_.height,
                          PixelFault::unchecked);
  }

  /// False when it was stopped.
  bool run_pass(int stride, std::stop_token stop) {
    for_each_tile(params_.width, params_.height, stop, [&](const Tile& tile, int) {
      for (int y = tile.y0; y < tile.y1; y += stride)
        for (int x = tile.x0; x < tile.x1; x += stride) check(x, y);
    });
    if (stop.stop_requested()) return false;
    count();
    return true;
  }
  const PixelFaults& faults() const { return faults_; }

 private:
  void check(int x, int y) {
    PixelFault& fault =
        faults_.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(params_.width) +
                       static_cast<std::size_t>(x)];
    if (fault == PixelFault::unchecked) fault = fault_of(sample_ray(eye_, x, y, Vec2(0.5f)));
  }

  PixelFault fault_of(const Ray& ray) const {
    NoObserver none;
    const Hit hit = trace_closest(world_, ray, rules_, none);
    switch (reference_.judge(ray, hit.object, hit.t, rules_.sides).verdict) {
      case Verdict::lost:
        return PixelFault::lost;
      case Verdict::phantom:
        return PixelFault::phantom;
      default:
        return hit && shades_itself(ray, hit) ? PixelFault::self_hit : PixelFault::none;
    }
  }

  bool shades_itself(const Ray& ray, const Hit& hit) const {
    NoObserver none;
    const Hit sure_hit = closest_hit(world_, ray, {.sides = rules_.sides}, none);
    if (sure_hit.object != hit.object) return false;
    const Surface found = surface_at(world_.scene, ray, hit);
    const Surface sure = surface_at(world_.scene, ray, sure_hit);
    return std::any_of(
        world_.scene.lights.begin(), world_.scene.lights.end(), [&](const Light& light) {
          const Vec3d way = Vec3d(light.position) - found.point;
          if (!(glm::dot(found.normal, way) > 0.0)) return false;
          const Ray shadow = shadow_ray(found, light, params_.offset);
          return trace_closest(world_, shadow, rules_, none).object == hit.object &&
                 leaves_freely(hit.object, shadow_ray(sure, light, OffsetRule::error_bounded));
        });
  }

  /// Whether a ray that surely starts off the object does not meet it.
  bool leaves_freely(std::uint32_t object, const Ray& ray) const {
    return exact_hits(world_.scene, object, ray, Sides::both)[0].meeting == Meeting::miss;
  }

  void count() {
    const auto with = [&](PixelFault fault) {
      return static_cast<std::size_t>(std::ranges::count(faults_.pixels, fault));
    };
    faults_.checked = faults_.pixels.size() - with(PixelFault::unchecked);
    faults_.lost = with(PixelFault::lost);
    faults_.phantom = with(PixelFault::phantom);
    faults_.self_hit = with(PixelFault::self_hit);
    faults_.complete = faults_.checked == faults_.pixels.size();
  }

  World world_;
  const Reference& reference_;
  RenderParams params_;
  TraceRules rules_;
  PrimaryRays eye_;
  PixelFaults faults_;
};

}  // namespace

void find_pixel_faults(const JudgedPicture& picture, std::stop_token stop,
                       const std::function<void(const PixelFaults&)>& publish) {
  if (picture.params.width <= 0 || picture.params.height <= 0) return;
  with_threads(picture.params.threads, [&] {
    FaultFinder finder(picture);
    for (const int stride : strides) {
      if (!finder.run_pass(stride, stop)) return;
      publish(finder.faults());
    }
  });
}

}  // namespace bspview
