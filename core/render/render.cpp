#include "core/render/render.h"

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

/// Every pixel with the same samples. See trace_image.
template <class MakeTracer, class Done>
Image trace_uniform(const Job& job, const MakeTracer& make_tracer, const Done& done) {
  const RenderParams& params = job.params;
  const PrimaryRays eye(job.camera, params.width, params.height);
  const int border = params.spd_rules ? 1 : 0;
  const std::vector<Vec2> offsets =
      params.spd_rules ? std::vector{Vec2(0.0f)} : sample_pattern(std::max(1, params.samples));
  Image image{params.width + border, params.height + border, {}};
  image.pixels.resize(static_cast<std::size_t>(image.width) * image.height);

  const int tiles = tile_count(image.width, image.height);
  for_each_tile(image.width, image.height, job.watch.stop, [&](const Tile& tile, int index) {
    auto tracer = make_tracer();
    Shader shader(job.scene, params, tracer);
    Hit hit;
    for_each_pixel(tile, [&](int x, int y) {
      Vec3 sum(0.0f);
      for (const Vec2 offset : offsets) sum += shader.eye_color(sample_ray(eye, x, y, offset), hit);
      image.pixels[static_cast<std::size_t>(y) * image.width + x] =
          sum / static_cast<float>(offsets.size());
    });
    done(tracer, index);
    job.watch.advance(1.0 / tiles);
  });
  return params.spd_rules ? mean_of_corners(image) : image;
}

/// Every pixel with as many samples as it needs, in rounds. See trace_image.
template <class MakeTracer, class Done>
Image trace_adaptive(const Job& job, const MakeTracer& make_tracer, const Done& done) {
  const RenderParams& params = job.params;
  const PrimaryRays eye(job.camera, params.width, params.height);
  const std::vector<Vec2> offsets = sample_pattern(std::max(1, params.samples));
  PixelSamples samples(params.width, params.height, params.adaptive);

  const auto trace_round = [&](std::span<const Vec2> round) {
    for_each_tile(params.width, params.height, job.watch.stop, [&](const Tile& tile, int index) {
      if (!samples.any_lives_in(index)) return;
      auto tracer = make_tracer();
      Shader shader(job.scene, params, tracer);
      Hit hit;
      for_each_pixel(tile, [&](int x, int y) {
        const std::size_t pixel = static_cast<std::size_t>(y) * params.width + x;
        if (!samples.lives(pixel)) return;
        for (const Vec2 at : round) {
          samples.add(pixel, shader.eye_color(sample_ray(eye, x, y, at), hit));
        }
      });
      done(tracer, index);
    });
  };
  for (std::size_t taken = 0; taken < offsets.size();) {
    const std::size_t more = std::min<std::size_t>(judged_samples, offsets.size() - taken);
    if (samples.any_lives()) trace_round(std::span(offsets).subspan(taken, more));
    taken += more;
    if (samples.judges_after(static_cast<int>(taken))) samples.judge(job.watch.stop);
    job.watch.advance(static_cast<double>(more) / static_cast<double>(offsets.size()));
  }
  return Image{params.width, params.height, samples.means()};
}

/// Traces the picture; for each tile, or for each tile of a round, make_tracer() makes the tracer
/// before it and done(tracer, tile index) takes it after.
template <class MakeTracer, class Done>
Result<Image> trace_image(const Job& job, const MakeTracer& make_tracer, const Done& done) {
  Image image;
  with_threads(job.params.threads, [&] {
    image = is_adaptive(job.params) ? trace_adaptive(job, make_tracer, done)
                                    : trace_uniform(job, make_tracer, done);
  });
  if (job.watch.stopped()) return stopped();
  return image;
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
  Hit hit;
  shader.eye_color(PrimaryRays(camera, params.width, params.height).ray(pixel.x, pixel.y), hit);
  return std::move(tracer.rays());
}

}  // namespace bspview
