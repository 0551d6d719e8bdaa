#include "core/eval/bench/rays.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/eval/random_numbers.h"
#include "core/render/surface.h"
#include "core/render/z_order.h"

namespace bspview {
namespace {

constexpr std::array<std::string_view, bench_kind_count> kind_names{"primary", "shadow",
                                                                    "scattered"};

constexpr int tile_side = 8;  // pixels
constexpr std::size_t tile_pixels = tile_side * tile_side;

/// A side of the picture in tiles.
int tiles_along(int pixels, double scale) {
  return std::max(1, static_cast<int>(std::lround(pixels * scale / tile_side)));
}

/// The same ray with a direction of length 1.
Ray normalised(Ray ray) {
  const double length = glm::length(Vec3d(ray.direction));
  ray.direction = Vec3(Vec3d(ray.direction) / length);
  ray.t_max = static_cast<float>(ray.t_max * length);
  return ray;
}

/// The eye rays of a tile whose upper left pixel is (left, top).
void add_tile(const PrimaryRays& picture, int left, int top, std::vector<Ray>& rays) {
  for (std::uint32_t i = 0; i < tile_pixels; ++i) {
    const GridPlace place = z_order(i);
    const Vec2 pixel(static_cast<float>(left + place.x), static_cast<float>(top + place.y));
    const Ray ray = picture.ray(pixel.x + 0.5f, pixel.y + 0.5f);
    rays.push_back(normalised(ray));
  }
}

std::vector<Ray> primary_rays(const Camera& camera, std::size_t count) {
  const double pixels = static_cast<double>(camera.width) * camera.height;
  const double scale = std::sqrt(static_cast<double>(count) / pixels);
  const int across = tiles_along(camera.width, scale), down = tiles_along(camera.height, scale);
  const PrimaryRays picture(camera, tile_side * across, tile_side * down);
  std::vector<Ray> rays;
  rays.reserve(static_cast<std::size_t>(across) * static_cast<std::size_t>(down) * tile_pixels);
  for (int tile = 0; tile < across * down; ++tile) {
    add_tile(picture, tile_side * (tile % across), tile_side * (tile / across), rays);
  }
  return rays;
}

/// Calls visit(surface, index of the ray) for every eye ray that hits something.
template <class Visit>
void for_each_hit(const World& world, std::span<const Ray> primary, const Visit& visit) {
  NoObserver none;
  for (std::size_t i = 0; i < primary.size(); ++i) {
    const Hit hit = closest_hit(world, primary[i], TraceRules{}, none);
    if (hit) visit(surface_at(world.scene, primary[i], hit), i);
  }
}

std::vector<Ray> shadow_rays(const World& world, std::span<const Ray> primary) {
  const std::vector<Light>& lights = world.scene.lights;
  std::vector<std::vector<Ray>> by_light(lights.size());
  const auto add = [&](const Surface& surface, std::size_t i) {
    const std::size_t turn = i / tile_pixels % lights.size();
    const Vec3d to_light = Vec3d(lights[turn].position) - surface.point;
    if (glm::dot(surface.normal, to_light) <= 0.0) return;
    const Ray ray = shadow_ray(surface, lights[turn], OffsetRule::error_bounded);
    by_light[turn].push_back(normalised(ray));
  };
  if (!lights.empty()) for_each_hit(world, primary, add);
  std::vector<Ray> rays;
  for (const auto& of_light : by_light) rays.insert(rays.end(), of_light.begin(), of_light.end());
  return rays;
}

std::vector<Ray> scattered_rays(const World& world, std::span<const Ray> primary,
                                std::uint64_t seed) {
  RandomNumbers random(seed);
  std::vector<Ray> rays;
  for_each_hit(world, primary, [&](const Surface& surface, std::size_t) {
    Vec3d direction = random.direction();
    if (glm::dot(direction, surface.normal) < 0.0) direction = -direction;
    rays.push_back(leaving_ray(surface, direction, OffsetRule::error_bounded));
  });
  for (std::size_t i = rays.size(); i > 1; --i) std::swap(rays[i - 1], rays[random.below(i)]);
  return rays;
}

}  // namespace

std::span<const std::string_view> bench_kind_names() {
  return kind_names;
}
std::string_view name_of(BenchKind kind) {
  return kind_names[static_cast<std::size_t>(kind)];
}

BenchBatch record_bench_rays(const World& world, BenchKind kind, std::size_t count,
                             std::uint64_t seed) {
  std::vector<Ray> primary = primary_rays(world.scene.camera, count);
  switch (kind) {
    case BenchKind::primary:
      break;
    case BenchKind::shadow:
      return {kind, shadow_rays(world, primary)};
    case BenchKind::scattered:
      return {kind, scattered_rays(world, primary, seed)};
  }
  return {kind, std::move(primary)};
}

}  // namespace bspview
