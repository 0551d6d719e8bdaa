#include "core/render/render.h"

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

/// Traces every pixel, one tracer a tile: make_tracer() before it, done(tracer, tile index) after.
template <class MakeTracer, class Done>
Result<Image> trace_image(const Job& job, const MakeTracer& make_tracer, const Done& done) {
  const RenderParams& params = job.params;
  const PrimaryRays eye(job.camera, params.width, params.height);
  const int border = params.spd_rules ? 1 : 0;
  const int samples = params.spd_rules ? 1 : std::max(1, params.samples);
  Image image{params.width + border, params.height + border, {}};
  image.pixels.resize(static_cast<std::size_t>(image.width) * image.height);

  const int tiles = tile_count(image.width, image.height);
  const auto trace_tile = [&](const Tile& tile, int index) {
    auto tracer = make_tracer();
    Shader shader(job.scene, params, tracer);
    Hit hit;
    for (int y = tile.y0; y < tile.y1; ++y) {
      for (int x = tile.x0; x < tile.x1; ++x) {
        Vec3 sum(0.0f);
        for (int sample = 0; sample < samples; ++sample) {
          const Vec2 offset = params.spd_rules ? Vec2(0.0f) : sample_offset(sample);
          const Ray ray =
              eye.ray(static_cast<float>(x) + offset.x, static_cast<float>(y) + offset.y);
          sum += shader.eye_color(ray, hit);
        }
        image.pixels[static_cast<std::size_t>(y) * image.width + x] =
            sum / static_cast<float>(samples);
      }
    }
    done(tracer, index);
    job.watch.advance(1.0 / tiles);
  };
  with_threads(params.threads,
               [&] { for_each_tile(image.width, image.height, job.watch.stop, trace_tile); });
  if (job.watch.stopped()) return stopped();
  return params.spd_rules ? mean_of_corners(image) : std::move(image);
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
        counts[static_cast<std::size_t>(tile)] = tracer.counts();
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
        tiles[static_cast<std::size_t>(tile)] = std::move(tracer.rays());
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
