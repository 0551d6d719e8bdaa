#include "core/eval/error/rays.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/eval/random_numbers.h"
#include "core/render/record.h"
#include "core/render/surface.h"

namespace bspview {
namespace {

constexpr std::array<std::string_view, ray_group_count> group_names{
    "primary", "shadow", "reflected", "refracted", "scattered", "edge", "vertex"};

/// Size of the picture with about `rays` pixels and the sides in proportion to the camera's.
RenderParams picture_of(const Camera& camera, const RecordParams& params) {
  const double pixels = static_cast<double>(camera.width) * camera.height;
  const double scale = std::sqrt(static_cast<double>(params.rays) / pixels);
  const auto side = [&](int whole) { return std::max(1, static_cast<int>(whole * scale + 0.5)); };
  RenderParams picture;
  picture.width = side(camera.width);
  picture.height = side(camera.height);
  picture.threads = params.threads;
  return picture;
}

/// At most `count` rays of one kind, evenly out of those recorded, in their order.
std::vector<Ray> rays_of_kind(std::span<const RecordedRay> recorded, RayKind kind,
                              std::size_t count) {
  std::vector<Ray> rays;
  for (const RecordedRay& ray : recorded) {
    if (ray.kind == kind) rays.push_back(ray.ray);
  }
  if (rays.size() <= count) return rays;
  for (std::size_t i = 0; i < count; ++i) rays[i] = rays[i * rays.size() / count];
  rays.resize(count);
  return rays;
}

/// One ray from every hit of `primary`, evenly over the side of the surface that was hit.
std::vector<Ray> scatter(const World& world, std::span<const Ray> primary, RandomNumbers& random) {
  std::vector<Ray> rays;
  NoObserver none;
  for (const Ray& ray : primary) {
    const Hit hit = closest_hit(world, ray, TraceRules{}, none);
    if (!hit) continue;
    const Surface surface = surface_at(world.scene, ray, hit);
    Vec3d direction = random.direction();
    if (glm::dot(direction, surface.normal) < 0.0) direction = -direction;
    rays.push_back({leaving_origin(surface, direction), Vec3(direction)});
  }
  for (std::size_t i = rays.size(); i > 1; --i) std::swap(rays[i - 1], rays[random.below(i)]);
  return rays;
}

/// A ray from somewhere around the scene to `target`.
Ray aimed_at(Vec3d target, double scene_size, RandomNumbers& random) {
  const Vec3 origin(target + (0.1 + random.unit()) * scene_size * random.direction());
  return {origin, Vec3(glm::normalize(target - Vec3d(origin)))};
}

/// Rays at edges (at vertices: the ends of edges) of random triangles.
std::vector<Ray> aim(const World& world, RayGroup group, std::size_t count, RandomNumbers& random) {
  const double size = glm::length(Vec3d(world.tree.box.hi) - Vec3d(world.tree.box.lo));
  std::vector<Ray> rays(count);
  for (Ray& ray : rays) {
    const Face& face = world.scene.faces[random.below(world.scene.faces.size())];
    const auto corners = vertices_of(world.scene, face);
    const std::size_t first = random.below(3);
    const Vec3d from(corners[first]), to(corners[(first + 1) % 3]);
    const double share = group == RayGroup::edge ? random.unit() : 0.0;
    ray = aimed_at(from + share * (to - from), size, random);
  }
  return rays;
}

}  // namespace

std::span<const std::string_view> ray_group_names() {
  return group_names;
}
std::string_view name_of(RayGroup group) {
  return group_names[static_cast<std::size_t>(group)];
}

bool has_only_triangles(const Scene& scene) {
  return !scene.objects.empty() && std::ranges::all_of(scene.objects, [](const Object& object) {
    return object.kind == ObjectKind::triangle;
  });
}

Result<std::vector<RayBatch>> record_batches(const World& world, const RecordParams& params,
                                             const Watch& watch) {
  const RenderParams picture = picture_of(world.scene.camera, params);
  const auto recorded = record_rays(world, world.scene.camera, picture, watch);
  if (!recorded) return recorded.error();
  RandomNumbers random(params.seed);
  std::vector<RayBatch> batches;
  const auto add = [&](RayGroup group, std::vector<Ray> rays) {
    if (!rays.empty()) batches.push_back({group, std::move(rays)});
  };
  const auto of_kind = [&](RayKind kind) { return rays_of_kind(*recorded, kind, params.rays); };
  const std::vector<Ray> primary = of_kind(RayKind::primary);
  add(RayGroup::primary, primary);
  add(RayGroup::shadow, of_kind(RayKind::shadow));
  add(RayGroup::reflected, of_kind(RayKind::reflected));
  add(RayGroup::refracted, of_kind(RayKind::refracted));
  add(RayGroup::scattered, scatter(world, primary, random));
  if (has_only_triangles(world.scene)) {
    for (const RayGroup group : {RayGroup::edge, RayGroup::vertex}) {
      add(group, aim(world, group, params.rays, random));
    }
  }
  return batches;
}

}  // namespace bspview
