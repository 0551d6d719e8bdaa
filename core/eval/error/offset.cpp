#include "core/eval/error/offset.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/eval/random_numbers.h"
#include "core/render/surface.h"

namespace bspview {
namespace {

constexpr std::size_t most_points = 20000;  // of a scene
constexpr float before_light = 1.0f - 0x1p-20f;
constexpr double near_ulps = 16.0;

/// A point where rays leave, and how.
struct Departure {
  Ray arriving;
  std::uint32_t object = no_index;
  Vec3d direction{0.0};  // at random, on the side of the surface that was hit
  Vec3 light{0.0f};
  bool light_is_hidden = false;
};

Hit default_hit(const World& world, const Ray& ray) {
  NoObserver none;
  return closest_hit(world, ray, TraceRules{}, none);
}

/// Whether a ray that leaves the surface outwards cannot meet it again.
bool is_final(const Scene& scene, std::uint32_t object, bool from_behind) {
  const Object& hit = scene.objects[object];
  if (hit.kind == ObjectKind::triangle || hit.kind == ObjectKind::polygon) return true;
  const bool inside_out =
      hit.kind == ObjectKind::sphere
          ? scene.spheres[hit.shape].radius < 0.0f
          : scene.cones[hit.shape].base_radius < 0.0f || scene.cones[hit.shape].apex_radius < 0.0f;
  return from_behind == inside_out;
}

Ray shadow_ray(Vec3 origin, Vec3 light) {
  return {origin, light - origin, 0.0f, before_light};
}

bool is_hidden(const JudgedScene& scene, const Ray& shadow, std::uint32_t surface) {
  const float size = largest_component(magnitudes(shadow.origin));
  const double least = near_ulps * 0x1p-23 * size / glm::length(Vec3d(shadow.direction));
  const std::vector<Candidate> met = scene.reference.meetings(shadow);
  return std::ranges::any_of(met, [&](const Candidate& one) {
    return one.object != surface && one.hit.meeting == Meeting::interior && one.hit.t > least;
  });
}

/// From where the default tests say that `ray` arrives; nothing where a surface can be met again.
std::optional<Departure> departure(const JudgedScene& scene, const Ray& ray,
                                   RandomNumbers& random) {
  const Scene& objects = scene.world.scene;
  const Hit hit = default_hit(scene.world, ray);
  if (!hit) return std::nullopt;
  const Surface surface = surface_at(objects, ray, hit);
  Departure departure{.arriving = ray, .object = hit.object, .direction = random.direction()};
  if (glm::dot(departure.direction, surface.normal) < 0.0) {
    departure.direction = -departure.direction;
  }
  if (!is_final(objects, hit.object, surface.from_behind)) return std::nullopt;
  if (objects.lights.empty()) return departure;
  departure.light = objects.lights[random.below(objects.lights.size())].position;
  const Vec3d to_light = Vec3d(departure.light) - surface.point;
  if (glm::dot(to_light, surface.normal) <= 0.0) return departure;
  const Ray shadow = shadow_ray(leaving_origin(surface, to_light), departure.light);
  departure.light_is_hidden = is_hidden(scene, shadow, hit.object);
  return departure;
}

std::vector<Departure> departures(const JudgedScene& scene, std::uint64_t seed) {
  std::vector<Departure> found;
  RandomNumbers random(seed);
  for (const RayBatch& batch : scene.batches) {
    if (batch.group != RayGroup::primary) continue;
    const std::size_t step = std::max<std::size_t>(1, batch.rays.size() / most_points);
    for (std::size_t i = 0; i < batch.rays.size(); i += step) {
      if (const auto one = departure(scene, batch.rays[i], random)) found.push_back(*one);
    }
  }
  return found;
}

OffsetCounts leave(const JudgedScene& scene, const BoundKernel& kernel,
                   std::span<const Departure> all) {
  OffsetCounts counts;
  for (const Departure& one : all) {
    RayResult hit;
    kernel.closest(std::span(&one.arriving, 1), std::span(&hit, 1));
    if (hit.object != one.object) continue;  // a wrong hit, counted elsewhere
    const Scene& objects = scene.world.scene;
    const Ray away = leaving_ray(objects, one.arriving, hit, *kernel.offset, one.direction);
    RayResult next;
    kernel.closest(std::span(&away, 1), std::span(&next, 1));
    ++counts.leaving;
    counts.acne += next.object == one.object;
    if (!one.light_is_hidden) continue;
    const Vec3d way = Vec3d(one.light) - Vec3d(one.arriving.at(static_cast<float>(hit.t)));
    const Ray towards = leaving_ray(objects, one.arriving, hit, *kernel.offset, way);
    const Ray shadow = shadow_ray(towards.origin, one.light);
    char blocked = 0;
    kernel.occluded(std::span(&shadow, 1), std::span(&blocked, 1));
    ++counts.hidden;
    counts.leaks += blocked == 0;
  }
  return counts;
}

}  // namespace

Ray leaving_ray(const Scene& scene, const Ray& ray, const RayResult& hit, OffsetRule rule,
                Vec3d direction) {
  if (rule == OffsetRule::fixed) {
    return {ray.at(static_cast<float>(hit.t)), Vec3(direction)};
  }
  Hit full;
  full.t = hit.t;
  full.object = hit.object;
  return {leaving_origin(surface_at(scene, ray, full), direction), Vec3(direction)};
}

std::vector<OffsetCounts> judge_offsets(const JudgedScene& scene,
                                        std::span<const BoundKernel> kernels, std::uint64_t seed) {
  const std::vector<Departure> all = departures(scene, seed);
  std::vector<OffsetCounts> counts(kernels.size());
  with_threads(scene.threads, [&] {
    parallel_for(static_cast<int>(kernels.size()), [&](int index) {
      const auto k = static_cast<std::size_t>(index);
      if (kernels[k].offset) counts[k] = leave(scene, kernels[k], all);
    });
  });
  return counts;
}

}  // namespace bspview
