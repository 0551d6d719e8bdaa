#include "core/bsp/validate.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "core/math/largest_coordinate.h"
#include "core/shape/outline.h"

namespace bspview {
namespace {

using ObjectIds = std::vector<std::uint32_t>;  // ascending

template <class... Args>
Error node_error(std::uint32_t node, fmt::format_string<Args...> format, Args&&... args) {
  return Error{fmt::format("node {}: {}", node, fmt::format(format, std::forward<Args>(args)...))};
}

bool overlap(const Aabb& a, const Aabb& b) {
  return !intersection(a, b).empty();
}

Aabb grown_by_8_ulp(const Aabb& cell) {
  const Vec3 largest(largest_coordinate(cell));
  return {cell.lo - 0x1p-20f * largest, cell.hi + 0x1p-20f * largest};
}

/// Which outlines of a polygon, found somewhere on the path and divided from there on, reach the
/// present cell. What clipping keeps of a concave one depends on the order of the cuts; it is not
/// in the cell if any of them says so.
struct OutlineReach {
  bool some = false, all = true;
};

/// The part of an outline in `cell` that is in `child`, one of the two cells that a plane makes.
Outline divide_into(const Aabb& cell, const Aabb& child, double margin, Outline part,
                    OutlineRoom& room) {
  int axis = 0;
  while (cell.lo[axis] == child.lo[axis] && cell.hi[axis] == child.hi[axis]) ++axis;
  const bool goes_left = cell.lo[axis] == child.lo[axis];
  const float plane = goes_left ? child.hi[axis] : child.lo[axis];
  LaneBox left, right;
  const OutlineSides sides = divide(part, lane_box(box_of(part, margin)), {axis, plane, margin},
                                    room.of(2 * outline_room(part.size())), {left, right});
  return goes_left ? sides.left : sides.right;
}

/// One walk over the whole tree, with the objects whose boxes touch the present cell.
class Walk {
 public:
  Walk(const Tree& tree, const BuildInput& input)
      : tree_(tree),
        input_(input),
        clip_(effective_clip(tree.params) && input.clip && !tree.naive),
        leaf_size_(static_cast<std::size_t>(std::max(1, tree.params.leaf_size))),
        node_seen_(tree.nodes.size()),
        reference_seen_(tree.references.size()) {}

  Result<void> check_node(std::uint32_t index, const Aabb& cell, const ObjectIds& touching);

  /// What no node led to; call it last.
  Result<void> check_nothing_left() const;

 private:
  int depth() const { return static_cast<int>(path_.size()) - 1; }
  Result<void> check_inner(std::uint32_t index, const ObjectIds& touching);
  Result<void> check_leaf(std::uint32_t index, const ObjectIds& touching);
  Result<void> check_range(std::uint32_t index);
  Result<void> check_present(std::uint32_t index, const ObjectIds& touching) const;
  Result<void> check_absent(std::uint32_t index, const ObjectIds& touching) const;
  bool clipping_keeps(std::uint32_t object) const;
  OutlineReach outlines_reach(std::uint32_t object) const;

  const Tree& tree_;
  const BuildInput& input_;
  bool clip_;
  std::size_t leaf_size_;
  std::vector<bool> node_seen_, reference_seen_;
  std::vector<Aabb> path_;  // cells from the root to the present node
};

Result<void> Walk::check_node(std::uint32_t index, const Aabb& cell, const ObjectIds& touching) {
  if (node_seen_[index]) return node_error(index, "has two parents");
  node_seen_[index] = true;
  path_.push_back(cell);
  const bool leaf = tree_.nodes[index].is_leaf();
  Result<void> result = leaf ? check_leaf(index, touching) : check_inner(index, touching);
  path_.pop_back();
  return result;
}

Result<void> Walk::check_inner(std::uint32_t index, const ObjectIds& touching) {
  const Node& node = tree_.nodes[index];
  const int axis = node.axis();
  const Aabb cell = path_.back();
  if (depth() >= tree_.max_depth) {
    return node_error(index, "is split at depth {}, the limit", depth());
  }
  if (!(cell.lo[axis] < node.split() && node.split() < cell.hi[axis])) {
    return node_error(index, "its plane at {} is not inside its cell, {} to {}", node.split(),
                      cell.lo[axis], cell.hi[axis]);
  }
  if (node.left() <= index || node.right() >= tree_.nodes.size()) {
    return node_error(index, "its children are {} and {}", node.left(), node.right());
  }
  if (!clip_ && touching.size() <= leaf_size_) {
    return node_error(index, "is split with {} objects", touching.size());
  }
  const Cells cells = split_cell(cell, axis, node.split());
  const auto check_child = [&](std::uint32_t child, const Aabb& child_cell) {
    ObjectIds inside;
    std::ranges::copy_if(touching, std::back_inserter(inside), [&](std::uint32_t object) {
      return overlap(input_.boxes[object], child_cell);
    });
    return check_node(child, child_cell, inside);
  };
  const Result<void> left = check_child(node.left(), cells.left);
  return left ? check_child(node.right(), cells.right) : left;
}

Result<void> Walk::check_leaf(std::uint32_t index, const ObjectIds& touching) {
  if (Result<void> range = check_range(index); !range) return range;
  if (Result<void> present = check_present(index, touching); !present) return present;
  return check_absent(index, touching);
}

/// The references of the leaf exist, belong to no other leaf, and ascend.
Result<void> Walk::check_range(std::uint32_t index) {
  const Node& leaf = tree_.nodes[index];
  const std::size_t end = std::size_t{leaf.first_reference()} + leaf.count();
  if (end > tree_.references.size()) {
    return node_error(index, "its references end at {} of {}", end, tree_.references.size());
  }
  for (std::size_t i = leaf.first_reference(); i < end; ++i) {
    if (reference_seen_[i]) return node_error(index, "shares reference {} with another leaf", i);
    reference_seen_[i] = true;
  }
  const auto objects = tree_.objects_of(leaf);
  const auto unordered = std::ranges::adjacent_find(objects, std::ranges::greater_equal{});
  if (unordered != objects.end()) {
    return node_error(index, "object {} is held twice or out of order", *unordered);
  }
  return {};
}

/// Every object of the leaf touches its cell.
Result<void> Walk::check_present(std::uint32_t index, const ObjectIds& touching) const {
  for (const std::uint32_t object : tree_.objects_of(tree_.nodes[index])) {
    if (object >= input_.boxes.size()) return node_error(index, "there is no object {}", object);
    const bool by_box = std::ranges::binary_search(touching, object);
    const bool is_cut_off = clip_ && input_.clip(object, grown_by_8_ulp(path_.back())).empty();
    if (!by_box || (is_cut_off && !outlines_reach(object).some)) {
      return node_error(index, "object {} does not touch the cell", object);
    }
  }
  return {};
}

/// Every object that touches the cell is in the leaf.
Result<void> Walk::check_absent(std::uint32_t index, const ObjectIds& touching) const {
  ObjectIds missing;
  std::ranges::set_difference(touching, tree_.objects_of(tree_.nodes[index]),
                              std::back_inserter(missing));
  for (const std::uint32_t object : missing) {
    if (!clip_ || (clipping_keeps(object) && outlines_reach(object).all)) {
      return node_error(index, "object {} touches the cell and is not in the leaf", object);
    }
  }
  return {};
}

/// Whether clipping finds something of the object in the present cell and in all around it.
bool Walk::clipping_keeps(std::uint32_t object) const {
  Aabb part = input_.boxes[object];
  return std::ranges::all_of(path_, [&](const Aabb& cell) {
    if (!overlap(part, cell)) return false;
    part = input_.clip(object, cell);
    return !part.empty();
  });
}

OutlineReach Walk::outlines_reach(std::uint32_t object) const {
  OutlineReach reach;
  const auto corners = input_.corners ? input_.corners(object) : std::span<const Vec3>();
  if (corners.size() <= 3) return reach;
  const Aabb& whole = input_.boxes[object];
  const double margin = outline_margin(tree_.box);
  for (std::size_t first = 0; first < path_.size(); ++first) {
    OutlineRooms found, divided;
    OutlineRoom *room = &divided.first, *spare = &divided.second;
    Outline part = find_outline(corners, whole, path_[first], margin, found);
    for (std::size_t i = first;; ++i) {
      const bool reaches = overlap(intersection(box_of(part, margin), whole), path_.back());
      reach.some |= reaches;
      reach.all &= reaches;
      if (i + 1 == path_.size()) break;
      part = divide_into(path_[i], path_[i + 1], margin, part, *room);
      std::swap(room, spare);
    }
  }
  return reach;
}

Result<void> Walk::check_nothing_left() const {
  const auto node = std::ranges::find(node_seen_, false);
  if (node != node_seen_.end()) {
    return node_error(static_cast<std::uint32_t>(node - node_seen_.begin()), "has no parent");
  }
  const auto reference = std::ranges::find(reference_seen_, false);
  if (reference != reference_seen_.end()) {
    return Error{
        fmt::format("reference {} belongs to no leaf", reference - reference_seen_.begin())};
  }
  return {};
}

/// What can be said without looking at the nodes.
Result<void> check_whole(const Tree& tree, const BuildInput& input) {
  if (tree.object_count != input.boxes.size()) {
    return Error{fmt::format("the tree is of {} objects, there are {}", tree.object_count,
                             input.boxes.size())};
  }
  if (tree.max_depth != effective_depth(tree.params, tree.object_count)) {
    return Error{fmt::format("the maximal depth is {}, not what was asked for", tree.max_depth)};
  }
  if (tree.nodes.empty()) return Error{"the tree has no root"};
  if (tree.naive && tree.nodes.size() > 1) return Error{"a naive tree has more than one node"};
  return {};
}

}  // namespace

Result<void> validate(const Tree& tree, const BuildInput& input) {
  if (Result<void> whole = check_whole(tree, input); !whole) return whole;
  ObjectIds objects;
  for (std::uint32_t object = 0; object < input.boxes.size(); ++object) {
    if (!is_placeable(input.boxes[object])) continue;
    if (!tree.box.contains(input.boxes[object])) {
      return Error{fmt::format("object {} reaches out of the tree's box", object)};
    }
    objects.push_back(object);
  }
  Walk walk(tree, input);
  const Result<void> nodes = walk.check_node(0, tree.box, objects);
  return nodes ? walk.check_nothing_left() : nodes;
}

}  // namespace bspview
