#include "core/render/render.h"

#include <new>
#include <span>

#include "core/render/adaptive.h"
#include "core/render/pixel_grid.h"
#include "core/render/record.h"

namespace bspview {
namespace {

/// One finished job of tracing: what every variant of a picture shares.
struct Job {
  const Scene& scene;
  const Camera& camera;
  const RenderParams& params;
  const Watch& watch;
};

Error stopped() {
  return {"stopped"};
}

/// Averages the rays through the four corners of each pixel (SPD).
Image mean_of_corners(const Image& corners) {
  Image image{corners.width - 1, corners.height - 1, {}};
  image.pixels.reserve(static_cast<std::size_t>(image.width) * image.height);
  for (int y = 0; y < image.height; ++y) {
    const Vec3* row = &corners.pixels[static_cast<std::size_t>(y) * corners.width];
    const Vec3* next = row + corners.width;
    for (int x = 0; x < image.width; ++x) {
      image.pixels.push_back(0.25f * (row[x] + row[x + 1] + next[x] + next[x + 1]));
    }
  }
  return image;
}

/// Where the rays of a pixel lie in it.
std::vector<Vec2> ray_offsets(const RenderParams& params) {
  return params.spd_rules ? std::vector{Vec2(0.0f)} : sample_pattern(std::max(1, params.samples));
}

/// Calls round(offsets) for the samples up to each judgement, or for all at once.
template <class TraceRound>
void in_rounds(std::span<const Vec2> offsets, const RenderParams& params, const TraceRound& round) {
  const std::size_t most = is_adaptive(params) ? judged_samples : offsets.size();
  for (std::size_t first = 0; first < offsets.size(); first += most) {
    round(offsets.subspan(first, std::min(most, offsets.size() - first)));
  }
}

/// The samples that the pixels that live get next.
struct Round {
  const PrimaryRays& eye;
  std::span<const Vec2> offsets;
  int width;  // of the picture
  PixelSamples& samples;
};

template <class Tracer>
void trace_tile(Shader<Tracer>& shader, const Tile& tile, const Round& round) {
  EyeRays rays;
  for (const Vec2 offset : round.offsets) {
    rays.clear();
    for_each_pixel(tile, [&](int x, int y) {
      const std::size_t pixel = static_cast<std::size_t>(y) * round.width + x;
      if (round.samples.lives(pixel)) rays.add(pixel, sample_ray(round.eye, x, y, offset));
    });
    rays.shade(shader, [&](std::size_t pixel, Vec3 color) { round.samples.add(pixel, color); });
  }
}

/// Traces every pixel; for each tile, or with adaptive sampling for each tile of a round,
/// make_tracer() makes the tracer before it and done(tracer, tile index) takes it after.
template <class MakeTracer, class Done>
Result<Image> trace_pixels(const Job& job, const MakeTracer& make_tracer, const Done& done) {
  const RenderParams& params = job.params;
  const PrimaryRays eye(job.camera, params.width, params.height);
  const std::vector<Vec2> offsets = ray_offsets(params);
  const int border = params.spd_rules ? 1 : 0;
  const int width = params.width + border, height = params.height + border;
  PixelSamples samples(width, height, is_adaptive(params) ? params.adaptive : 0.0f);

  const double all = static_cast<double>(offsets.size()) * tile_count(width, height);
  const auto trace_round = [&](std::span<const Vec2> next) {
    for_each_tile(width, height, job.watch.stop, [&](const Tile& tile, int index) {
      if (samples.any_lives_in(index)) {
        auto tracer = make_tracer();
        Shader shader(job.scene, params, tracer);
        trace_tile(shader, tile, Round{eye, next, width, samples});
        done(tracer, index);
      }
      job.watch.advance(static_cast<double>(next.size()) / all);
    });
    samples.judge(job.watch.stop);
  };
  with_threads(params.threads, [&] { in_rounds(offsets, params, trace_round); });
  if (job.watch.stopped()) return stopped();
  Image image{width, height, std::move(samples).means()};
  return params.spd_rules ? mean_of_corners(image) : std::move(image);
}

/// trace_pixels, with an error where memory runs out.
template <class MakeTracer, class Done>
Result<Image> trace_image(const Job& job, const MakeTracer& make_tracer, const Done& done) {
  try {
    return trace_pixels(job, make_tracer, done);
  } catch (const std::bad_alloc&) {
    return Error{"not enough memory for the picture"};
  }
}

/// Each ray before all that it leads to, in the order in which they were sent.
std::vector<PathRay> depth_first(std::span<const PathRay> rays) {
  std::vector<std::vector<int>> sent(rays.size());
  for (std::size_t i = 1; i < rays.size(); ++i) {
    sent[static_cast<std::size_t>(rays[i].parent)].push_back(static_cast<int>(i));
  }
  std::vector<PathRay> ordered;
  const auto add = [&](const auto& self, std::size_t ray, int parent) -> void {
    const auto index = static_cast<int>(ordered.size());
    ordered.push_back(rays[ray]);
    ordered.back().parent = parent;
    for (const int next : sent[ray]) self(self, static_cast<std::size_t>(next), index);
  };
  if (!rays.empty()) add(add, 0, -1);
  return ordered;
}

int tiles_of(const RenderParams& params) {
  const int border = params.spd_rules ? 1 : 0;
  return tile_count(params.width + border, params.height + border);
}

}  // namespace

Result<Image> render_image(const World& world, const Camera& camera, const RenderParams& params,
                           const Watch& watch) {
  return trace_image(
      Job{world.scene, camera, params, watch},
      [&] { return PlainTracer(world, trace_rules(params)); }, [](PlainTracer&, int) {});
}

Result<CountedImage> render_counted(const World& world, const Camera& camera,
                                    const RenderParams& params, const Watch& watch) {
  std::vector<RayCounts> counts(static_cast<std::size_t>(tiles_of(params)));
  auto image = trace_image(
      Job{world.scene, camera, params, watch},
      [&] { return CountTracer(world, trace_rules(params)); },
      [&](CountTracer& tracer, int tile) {
        counts[static_cast<std::size_t>(tile)] += tracer.counts();
      });
  if (!image) return image.error();
  CountedImage result{std::move(*image), {}};
  for (const RayCounts& tile : counts) result.counts += tile;
  return result;
}

Result<Image> render_with(const Scene& scene, const RayKernel& kernel, const Camera& camera,
                          const RenderParams& params, const Watch& watch) {
  return trace_image(
      Job{scene, camera, params, watch}, [&] { return KernelTracer(kernel); },
      [](KernelTracer&, int) {});
}

Result<Image> render_reference(const Scene& scene, const Camera& camera, const RenderParams& params,
                               const Watch& watch) {
  return trace_image(
      Job{scene, camera, params, watch},
      [&] { return ReferenceTracer(scene, trace_rules(params)); }, [](ReferenceTracer&, int) {});
}

Result<std::vector<RecordedRay>> record_rays(const World& world, const Camera& camera,
                                             const RenderParams& params, const Watch& watch) {
  std::vector<std::vector<RecordedRay>> tiles(static_cast<std::size_t>(tiles_of(params)));
  const auto image = trace_image(
      Job{world.scene, camera, params, watch},
      [&] { return RecordTracer(world, trace_rules(params)); },
      [&](RecordTracer& tracer, int tile) {
        auto& rays = tiles[static_cast<std::size_t>(tile)];
        rays.insert(rays.end(), tracer.rays().begin(), tracer.rays().end());
      });
  if (!image) return image.error();
  std::vector<RecordedRay> rays;
  for (auto& tile : tiles) {
    rays.insert(rays.end(), tile.begin(), tile.end());
    tile = {};
  }
  return rays;
}

std::vector<PathRay> trace_pixel(const World& world, const Camera& camera,
                                 const RenderParams& params, Vec2 pixel) {
  PathTracer tracer(world, trace_rules(params));
  Shader shader(world.scene, params, tracer);
  const Ray ray = PrimaryRays(camera, params.width, params.height).ray(pixel.x, pixel.y);
  Hit hit;
  Vec3 color;
  shader.trace({&ray, 1}, {&hit, 1}, {&color, 1});
  return depth_first(tracer.rays());
}

}  // namespace bspview
