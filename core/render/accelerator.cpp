#include "core/render/accelerator.h"

#include <algorithm>
#include <limits>
#include <new>
#include <utility>

#include "core/base/timer.h"

namespace bspview {
namespace {

bool is_triangle(const Scene& scene, std::uint32_t object) {
  return scene.objects[object].kind == ObjectKind::triangle;
}

/// How far what counts as a hit may lie beside an object's box. Triangles are decided exactly; the
/// tests of round shapes round, and polygons are met where their vertices are off their plane.
float margin_around(const Scene& scene, std::uint32_t id, const Aabb& box) {
  const Object& object = scene.objects[id];
  if (object.kind == ObjectKind::triangle) return 0.0f;
  const Vec3 far = glm::max(glm::abs(box.lo), glm::abs(box.hi));
  const float rounding = 0x1p-23f * largest_component(far);
  if (object.kind != ObjectKind::polygon) return rounding;
  const PolygonPlane& plane = scene.planes[scene.faces[object.shape].plane];
  const Vec3d slopes = glm::abs(plane.normal);
  return rounding +
         static_cast<float>(2.0 * plane.thickness / std::max({slopes.x, slopes.y, slopes.z}));
}

Aabb hit_bounds(const Scene& scene, std::uint32_t id) {
  const Aabb box = object_bounds(scene, id);
  if (box.empty()) return box;
  const float margin = margin_around(scene, id, box);
  return margin > 0.0f ? Aabb{box.lo - margin, box.hi + margin} : box;
}

std::vector<Aabb> hit_bounds(const Scene& scene) {
  std::vector<Aabb> boxes;
  boxes.reserve(scene.objects.size());
  for (std::uint32_t id = 0; id < scene.objects.size(); ++id) {
    boxes.push_back(hit_bounds(scene, id));
  }
  return boxes;
}

TriangleBlock make_block(const Scene& scene, std::span<const std::uint32_t> triangles) {
  TriangleBlock block;
  for (std::size_t slot = 0; slot < TriangleBlock::width; ++slot) {
    const bool is_used = slot < triangles.size();
    block.object[slot] = is_used ? triangles[slot] : no_index;
    const Vec3* corners = nullptr;
    if (is_used) {
      const Face& face = scene.faces[scene.objects[triangles[slot]].shape];
      corners = &scene.vertices[face.first_vertex];
    }
    for (int vertex = 0; vertex < 3; ++vertex) {
      for (int axis = 0; axis < 3; ++axis) {
        block.vertices[vertex][axis][slot] =
            is_used ? corners[vertex][axis] : std::numeric_limits<float>::quiet_NaN();
      }
    }
  }
  return block;
}

}  // namespace

std::uint32_t Accelerator::make_leaf(const Scene& scene, std::span<const std::uint32_t> objects) {
  std::vector<std::uint32_t> triangles;
  WideLeaf leaf{static_cast<std::uint32_t>(blocks_.size()), 0,
                static_cast<std::uint32_t>(others_.size()), 0};
  for (const std::uint32_t object : objects) {
    (is_triangle(scene, object) ? triangles : others_).push_back(object);
  }
  add_blocks(scene, triangles);
  leaf.block_count = static_cast<std::uint32_t>(blocks_.size()) - leaf.first_block;
  leaf.other_count = static_cast<std::uint32_t>(others_.size()) - leaf.first_other;
  const bool is_short =
      leaf.block_count <= most_blocks && leaf.first_block < mixed_bit >> count_bits;
  if (leaf.other_count == 0 && is_short) return leaf.first_block << count_bits | leaf.block_count;
  mixed_.push_back(leaf);
  return mixed_bit | static_cast<std::uint32_t>(mixed_.size() - 1);
}

void Accelerator::add_blocks(const Scene& scene, std::span<const std::uint32_t> triangles) {
  while (!triangles.empty()) {
    const std::size_t count = std::min<std::size_t>(TriangleBlock::width, triangles.size());
    blocks_.push_back(make_block(scene, triangles.first(count)));
    triangles = triangles.subspan(count);
  }
}

std::size_t Accelerator::bytes() const {
  return tree_.bytes() + blocks_.size() * sizeof(TriangleBlock) +
         others_.size() * sizeof(std::uint32_t) + mixed_.size() * sizeof(WideLeaf);
}

std::shared_ptr<const Accelerator> make_accelerator(const World& world, std::stop_token stop) {
  if (world.tree.naive) return nullptr;
  const Timer timer;
  const Scene& scene = world.scene;
  try {
    const auto accelerator = std::make_shared<Accelerator>();
    const WideLeaves leaves{
        [&](std::span<const std::uint32_t> ids) { return accelerator->make_leaf(scene, ids); },
        [&](std::uint32_t id) { return is_triangle(scene, id); }};
    auto tree = make_wide_tree(world.tree, hit_bounds(scene), leaves, std::move(stop));
    if (!tree) return nullptr;
    accelerator->tree_ = *std::move(tree);
    accelerator->build_seconds_ = timer.seconds();
    return accelerator;
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

}  // namespace bspview
