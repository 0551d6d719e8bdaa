#include "core/render/part_boxes.h"

#include <algorithm>
#include <utility>

#include "core/render/hit_bounds.h"
#include "core/shape/triangle_block.h"

namespace bspview {
namespace {

bool is_triangle(const Scene& scene, const ObjectPart& part) {
  return scene.objects[part.object].kind == ObjectKind::triangle;
}

}  // namespace

PartBoxes::PartBoxes(const Scene& scene, std::span<const ObjectPart> parts) {
  for (const ObjectPart& part : parts) {
    if (is_triangle(scene, part)) add(part.object, part.box, TriangleBlock::width);
  }
  for (const ObjectPart& part : parts) {
    if (!is_triangle(scene, part)) add(part.object, hit_bounds(scene, part), 1);
  }
}

RawVector<WideNode> PartBoxes::make_nodes() {
  RawVector<WideNode> nodes(1);  // the root, which is known last
  while (children_.size() > WideNode::width) {
    std::vector<Child> parents;
    for (std::size_t i = 0; i < children_.size(); i += WideNode::width) {
      parents.push_back(add_node(i, nodes));
    }
    children_ = std::move(parents);
  }
  nodes[0] = node_of(children_);
  return nodes;
}

/// To the last leaf, while that has fewer than `most` objects.
void PartBoxes::add(std::uint32_t object, const Aabb& box, std::uint32_t most) {
  if (leaves_.ranges.empty() || leaves_.ranges.back().count >= most) {
    const auto leaf = static_cast<std::uint32_t>(leaves_.ranges.size());
    leaves_.ranges.push_back({static_cast<std::uint32_t>(leaves_.objects.size()), 0});
    children_.push_back({{}, WideNode::leaf_bit | leaf});
  }
  leaves_.objects.push_back(object);
  ++leaves_.ranges.back().count;
  children_.back().box.grow(box);
}

PartBoxes::Child PartBoxes::add_node(std::size_t first, RawVector<WideNode>& nodes) const {
  const std::size_t count = std::min<std::size_t>(WideNode::width, children_.size() - first);
  const auto children = std::span(children_).subspan(first, count);
  Child parent{{}, static_cast<std::uint32_t>(nodes.size())};
  for (const Child& child : children) parent.box.grow(child.box);
  nodes.push_back(node_of(children));
  return parent;
}

WideNode PartBoxes::node_of(std::span<const Child> children) {
  WideNode node = WideNode::without_cells();
  for (int slot = 0; slot < static_cast<int>(children.size()); ++slot) {
    const Child& child = children[static_cast<std::size_t>(slot)];
    node.set_bounds(slot, child.box);
    node.child[slot] = child.name;
  }
  return node;
}

}  // namespace bspview
