#include <algorithm>
#include <array>
#include <optional>

#include "core/base/timer.h"
#include "core/render/adaptive.h"
#include "core/render/pixel_grid.h"

namespace bspview {
namespace {

/// Distance of the pixels traced in the first passes, in both directions.
constexpr std::array<int, 4> strides{8, 4, 2, 1};

/// A progressive picture at work.
class Progress {
 public:
  Progress(const ProgressiveWorlds& worlds, const Camera& camera, const RenderParams& params,
           std::stop_token stop)
      : worlds_(worlds),
        params_(params),
        stop_(stop),
        eye_(camera, params.width, params.height),
        offsets_(sample_pattern(std::max(1, params.samples))),
        samples_(params.width, params.height, is_adaptive(params) ? params.adaptive : 0.0f) {
    const std::size_t pixels = static_cast<std::size_t>(params.width) * params.height;
    frame_.width = params.width;
    frame_.height = params.height;
    frame_.color.assign(pixels, worlds.counted.scene.background);
    frame_.distance.assign(pixels, std::numeric_limits<float>::infinity());
    frame_.object.assign(pixels, no_index);
    frame_.leaf.assign(pixels, no_leaf);
    frame_.pass_count = static_cast<int>(strides.size() + offsets_.size()) - 1;
  }

  /// What the eye rays of the first pass hit; false when it was stopped.
  bool look() {
    const TraceRules rules = trace_rules(params_);
    for_each_tile(params_.width, params_.height, stop_, [&](const Tile& tile, int) {
      NoObserver none;
      for (int y = tile.y0; y < tile.y1; y += strides[0]) {
        for (int x = tile.x0; x < tile.x1; x += strides[0]) {
          const Ray ray = sample_ray(eye_, x, y, offsets_[0]);
          set_hit(index(x, y), trace_closest(worlds_.counted, ray, rules, none));
          spread(tile, x, y, strides[0]);
        }
      }
    });
    return !stop_.stop_requested();
  }

  /// Pass number frame().pass; false when it was stopped.
  bool run_pass() {
    const int coarse = static_cast<int>(strides.size());
    if (frame_.pass < coarse) {
      trace_stride(frame_.pass);
    } else {
      add_sample(static_cast<std::size_t>(frame_.pass - coarse) + 1);
    }
    if (stop_.stop_requested()) return false;
    ++frame_.pass;
    if (!samples_.any_lives()) frame_.pass_count = frame_.pass;
    frame_.counted = frame_.pass >= coarse;
    frame_.seconds = timer_.seconds();
    return true;
  }
  const Frame& frame() const { return frame_; }

 private:
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * params_.width + x; }

  /// One centre ray in every stride-th pixel that has none yet; it colours its whole block.
  void trace_stride(int pass) {
    const int stride = strides[static_cast<std::size_t>(pass)];
    const int done_stride = pass == 0 ? 0 : strides[static_cast<std::size_t>(pass) - 1];
    std::vector<RayCounts> counts(
        static_cast<std::size_t>(tile_count(params_.width, params_.height)));
    for_each_tile(params_.width, params_.height, stop_, [&](const Tile& tile, int number) {
      CountTracer tracer(worlds_.counted, trace_rules(params_));
      Shader shader(worlds_.counted.scene, params_, tracer);
      for (int y = tile.y0; y < tile.y1; y += stride) {
        for (int x = tile.x0; x < tile.x1; x += stride) {
          const bool done = done_stride > 0 && x % done_stride == 0 && y % done_stride == 0;
          if (!done) trace_centre(shader, x, y);
          spread(tile, x, y, stride);
        }
      }
      counts[static_cast<std::size_t>(number)] = tracer.counts();
    });
    for (const RayCounts& tile : counts) frame_.counts += tile;
  }

  void trace_centre(Shader<CountTracer>& shader, int x, int y) {
    Hit hit;
    const std::size_t i = index(x, y);
    const Ray ray = sample_ray(eye_, x, y, offsets_[0]);
    shader.trace({&ray, 1}, {&hit, 1}, {&frame_.color[i], 1});
    samples_.add(i, frame_.color[i]);
    set_hit(i, hit);
  }

  void set_hit(std::size_t i, const Hit& hit) {
    frame_.distance[i] = static_cast<float>(hit.t);
    frame_.object[i] = hit.object;
    frame_.leaf[i] = hit.leaf;
  }

  /// Copies pixel (x, y) over its block.
  void spread(const Tile& tile, int x, int y, int stride) {
    const std::size_t from = index(x, y);
    for (int v = y; v < std::min(y + stride, tile.y1); ++v) {
      for (int u = x; u < std::min(x + stride, tile.x1); ++u) {
        const std::size_t to = index(u, v);
        frame_.color[to] = frame_.color[from];
        frame_.distance[to] = frame_.distance[from];
        frame_.object[to] = frame_.object[from];
        frame_.leaf[to] = frame_.leaf[from];
      }
    }
  }

  /// Sample number `sample` in every pixel that lives.
  void add_sample(std::size_t sample) {
    if (!fast_world_) fast_world_.emplace(worlds_.fast ? worlds_.fast() : worlds_.counted);
    for_each_tile(params_.width, params_.height, stop_, [&](const Tile& tile, int number) {
      if (!samples_.any_lives_in(number)) return;
      PlainTracer tracer(*fast_world_, trace_rules(params_));
      Shader shader(fast_world_->scene, params_, tracer);
      EyeRays rays;
      for_each_pixel(tile, [&](int x, int y) {
        const std::size_t i = index(x, y);
        if (samples_.lives(i)) rays.add(i, sample_ray(eye_, x, y, offsets_[sample]));
      });
      rays.shade(shader, [&](std::size_t i, Vec3 color) {
        samples_.add(i, color);
        frame_.color[i] = samples_.mean(i);
      });
    });
    if ((sample + 1) % judged_samples == 0) samples_.judge(stop_);
  }

  const ProgressiveWorlds& worlds_;
  std::optional<World> fast_world_;
  RenderParams params_;
  std::stop_token stop_;
  PrimaryRays eye_;
  std::vector<Vec2> offsets_;  // of the samples in their pixel
  PixelSamples samples_;
  Frame frame_;
  Timer timer_;
};

}  // namespace

void render_progressive(const ProgressiveWorlds& worlds, const Camera& camera,
                        const RenderParams& params, std::stop_token stop,
                        const std::function<void(const Frame&)>& publish) {
  if (params.width <= 0 || params.height <= 0) return;
  with_threads(params.threads, [&] {
    Progress progress(worlds, camera, params, stop);
    if (worlds.looks_first) {
      if (!progress.look()) return;
      publish(progress.frame());
    }
    while (progress.frame().pass < progress.frame().pass_count) {
      if (!progress.run_pass()) return;
      publish(progress.frame());
    }
  });
}

}  // namespace bspview
