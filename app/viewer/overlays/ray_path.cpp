#include "app/viewer/overlays/ray_path.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/viewer/overlays/object_wireframe.h"
#include "app/viewer/overlays/rgba.h"
#include "core/render/color_map.h"

namespace bspview {
namespace {

constexpr std::size_t most_outlines = 1000;
constexpr float cell_mark = 3.0f, hit_mark = 7.0f;  // half sizes, pixels
const std::uint32_t highlight_color = 0xffffffffu;
const std::uint32_t object_color = pack_color({0.85f, 0.85f, 0.85f}, 0.7f);

class RayPathLines {
 public:
  explicit RayPathLines(const RayPathScene& world) : world_(world) {}

  void add_context(std::span<const PathRay> rays) {
    for (const PathRay& ray : rays) add_ray(ray, 1.0f);
  }

  void add_selected(const PathRay& ray, int step) {
    add_objects(ray);
    add_cells(ray);
    add_marks(ray);
    add_ray(ray, 2.5f);
    if (0 <= step && step < static_cast<int>(ray.log.steps.size())) add_highlight(ray, step);
    if (ray.object != no_index) add_diamond(ray.ray.at(static_cast<float>(ray.t)));
  }

  LineList take() { return std::move(lines_); }

 private:
  void add_line(const Line& pen, Vec3 from, Vec3 to) {
    lines_.push_back({from, to, pen.color, pen.width});
  }

  /// Where the drawn ray ends: at its hit, at the light, or behind the scene.
  float end_of(const PathRay& ray) const {
    if (ray.object != no_index) return static_cast<float>(ray.t);
    if (std::isfinite(ray.ray.t_max)) return ray.ray.t_max;
    const Aabb box = world_.cells.cell(0);
    const float reach = glm::length(box.centre() - ray.ray.origin) + glm::length(box.extent());
    return reach / glm::length(ray.ray.direction);
  }

  void add_ray(const PathRay& ray, float width) {
    add_line({.color = ray_color(ray.kind), .width = width}, ray.ray.at(ray.ray.t_min),
             ray.ray.at(end_of(ray)));
  }

  void add_cells(const PathRay& ray) {
    std::vector<std::uint32_t> leaves;
    for (const RayStep& step : ray.log.steps) {
      if (step.kind == StepKind::leaf) leaves.push_back(step.node);
    }
    const float last = std::max(1.0f, static_cast<float>(leaves.size()) - 1.0f);
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      const std::uint32_t color = cell_color(static_cast<float>(i) / last);
      add_box(lines_, world_.cells.cell(leaves[i]), {.color = color, .width = 1.25f});
    }
  }

  void add_objects(const PathRay& ray) {
    std::vector<std::uint32_t> objects;
    for (const ObjectTest& test : ray.log.tests) objects.push_back(test.object);
    std::sort(objects.begin(), objects.end());
    objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
    objects.resize(std::min(objects.size(), most_outlines));
    for (const std::uint32_t object : objects) {
      add_wireframe(lines_, world_.scene, object, {.color = object_color});
    }
  }

  /// Crosses where the ray enters and leaves leaf cells.
  void add_marks(const PathRay& ray) {
    const float end = end_of(ray);
    for (const RayStep& step : ray.log.steps) {
      if (step.kind != StepKind::leaf) continue;
      add_cross(ray.ray.at(std::clamp(step.t_enter, ray.ray.t_min, end)), ray_color(ray.kind));
      if (step.t_exit <= end) add_cross(ray.ray.at(step.t_exit), ray_color(ray.kind));
    }
  }

  void add_highlight(const PathRay& ray, int index) {
    const RayStep& step = ray.log.steps[index];
    const Line pen{.color = highlight_color, .width = 3.0f};
    const auto tests = std::span(ray.log.tests).subspan(step.first_test, step.test_count);
    for (const ObjectTest& test : tests.first(std::min(tests.size(), most_outlines))) {
      add_wireframe(lines_, world_.scene, test.object, pen);
    }
    add_box(lines_, world_.cells.cell(step.node), pen);
  }

  /// World length that looks `pixels` long at `point`.
  float length_of(float pixels, Vec3 point) const {
    const float depth = world_.transform.homogeneous(point).z;
    return pixels * world_.transform.pixel_size() * std::max(depth, 0.0f);
  }

  void add_cross(Vec3 point, std::uint32_t color) {
    const float size = length_of(cell_mark, point);
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 arm(0.0f);
      arm[axis] = size;
      add_line({.color = color, .width = 1.5f}, point - arm, point + arm);
    }
  }

  /// The edges of an octahedron.
  void add_diamond(Vec3 point) {
    const float size = length_of(hit_mark, point);
    for (int i = 0; i < 12; ++i) {
      const int axis = i / 4;
      Vec3 from(0.0f), to(0.0f);
      from[axis] = i & 1 ? size : -size;
      to[(axis + 1) % 3] = i & 2 ? size : -size;
      add_line({.color = hit_color(), .width = 2.0f}, point + from, point + to);
    }
  }

  const RayPathScene& world_;
  LineList lines_;
};

}  // namespace

std::uint32_t ray_color(RayKind kind) {
  switch (kind) {
    case RayKind::primary:
      return pack_color({1.0f, 0.85f, 0.2f});
    case RayKind::reflected:
      return pack_color({0.3f, 0.85f, 1.0f});
    case RayKind::refracted:
      return pack_color({0.9f, 0.5f, 1.0f});
    case RayKind::shadow:
      break;
  }
  return pack_color({0.65f, 0.65f, 0.65f});
}

std::uint32_t cell_color(float order) {
  return pack_color(sample(ColorMap::magma, 0.4f + 0.55f * order));
}

std::uint32_t hit_color() {
  return pack_color({1.0f, 0.25f, 0.2f});
}

LineList ray_path_lines(const RayPathScene& world, std::span<const PathRay> rays,
                        const RaySelection& selection) {
  RayPathLines lines(world);
  lines.add_context(rays);
  if (0 <= selection.ray && selection.ray < static_cast<int>(rays.size())) {
    lines.add_selected(rays[selection.ray], selection.step);
  }
  return lines.take();
}

}  // namespace bspview
