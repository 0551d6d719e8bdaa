#include "core/bsp/wide_tree.h"

#include <algorithm>
#include <array>
#include <utility>

namespace bspview {
namespace {

/// The objects below a node while they can be one leaf.
class FewObjects {
 public:
  static FewObjects none_joined() {
    FewObjects objects;
    objects.are_few_ = false;
    return objects;
  }

  bool are_few() const { return are_few_; }
  std::span<const std::uint32_t> ids() const { return {ids_.data(), count_}; }

  void add(std::uint32_t object) {
    if (std::ranges::find(ids(), object) != ids().end()) return;
    if (count_ == ids_.size()) {
      are_few_ = false;
    } else {
      ids_[count_++] = object;
    }
  }
  void add(const FewObjects& others) {
    are_few_ = are_few_ && others.are_few_;
    for (const std::uint32_t object : others.ids()) add(object);
  }

 private:
  std::array<std::uint32_t, most_joined_objects> ids_;
  std::size_t count_ = 0;
  bool are_few_ = true;
};

class Widener {
 public:
  Widener(const Tree& tree, std::span<const Aabb> boxes, const WideLeaves& leaves,
          std::stop_token stop)
      : tree_(tree),
        boxes_(boxes),
        leaves_(leaves),
        stop_(std::move(stop)),
        parts_(tree.nodes.size()) {}

  std::optional<WideTree> make() {
    look_at(0, tree_.box);
    if (is_leaf(0)) {
      make_node(parts_[0].box.empty() ? Slots{} : Slots{0});
    } else {
      make_node(slots_below(0));
    }
    if (stop_.stop_requested()) return {};
    return std::move(wide_);
  }

 private:
  /// What is below a node of the binary tree.
  struct Part {
    Aabb box;  ///< of the parts of objects in its cell
    bool is_one_leaf = false;
  };
  using Slots = std::vector<std::uint32_t>;  // nodes of the binary tree

  bool is_leaf(std::uint32_t index) const {
    return tree_.nodes[index].is_leaf() || parts_[index].is_one_leaf;
  }

  /// Fills parts_ for a node and everything below.
  FewObjects look_at(std::uint32_t index, const Aabb& cell) {
    const Node& node = tree_.nodes[index];
    if (stop_.stop_requested()) return {};
    if (node.is_leaf()) return look_at_leaf(index, cell);
    const Cells cells = split_cell(cell, node.axis(), node.split());
    FewObjects objects = look_at(node.left(), cells.left);
    objects.add(look_at(node.right(), cells.right));
    parts_[index] = {parts_[node.left()].box, objects.are_few()};
    if (!parts_[node.right()].box.empty()) parts_[index].box.grow(parts_[node.right()].box);
    return objects;
  }

  FewObjects look_at_leaf(std::uint32_t index, const Aabb& cell) {
    FewObjects objects;
    bool can_join = true;
    for (const std::uint32_t object : tree_.objects_of(tree_.nodes[index])) {
      parts_[index].box.grow(intersection(boxes_[object], cell));
      objects.add(object);
      can_join = can_join && leaves_.joins(object);
    }
    return can_join ? objects : FewObjects::none_joined();
  }

  /// The cells that a node is replaced by: again and again the largest is split, while there is
  /// room.
  Slots slots_below(std::uint32_t index) const {
    Slots slots;
    add_children(index, slots);
    for (;;) {
      const auto has_room = [&](std::uint32_t slot) {
        return !is_leaf(slot) && slots.size() + full_children(slot) <= WideNode::width + 1;
      };
      auto largest = slots.end();
      for (auto slot = slots.begin(); slot != slots.end(); ++slot) {
        if (!has_room(*slot)) continue;
        const bool is_larger = largest == slots.end() ||
                               half_area(parts_[*slot].box) > half_area(parts_[*largest].box);
        if (is_larger) largest = slot;
      }
      if (largest == slots.end()) return slots;
      const std::uint32_t split = *largest;
      slots.erase(largest);
      add_children(split, slots);
    }
  }

  bool is_full(std::uint32_t index) const { return !parts_[index].box.empty(); }
  std::size_t full_children(std::uint32_t index) const {
    const Node& node = tree_.nodes[index];
    return std::size_t{is_full(node.left())} + std::size_t{is_full(node.right())};
  }
  void add_children(std::uint32_t index, Slots& slots) const {
    const Node& node = tree_.nodes[index];
    if (is_full(node.left())) slots.push_back(node.left());
    if (is_full(node.right())) slots.push_back(node.right());
  }

  std::uint32_t make_node(const Slots& slots) {
    const auto index = static_cast<std::uint32_t>(wide_.nodes.size());
    if (stop_.stop_requested()) return index;
    wide_.nodes.emplace_back();
    WideNode node{};
    for (int slot = 0; slot < WideNode::width; ++slot) {
      const bool is_used = static_cast<std::size_t>(slot) < slots.size();
      const Aabb box = is_used ? parts_[slots[static_cast<std::size_t>(slot)]].box : Aabb{};
      for (int axis = 0; axis < 3; ++axis) {
        node.bounds[2 * axis][slot] = box.lo[axis];
        node.bounds[2 * axis + 1][slot] = box.hi[axis];
      }
      if (is_used) node.child[slot] = make_child(slots[static_cast<std::size_t>(slot)]);
    }
    wide_.nodes[index] = node;
    return index;
  }

  std::uint32_t make_child(std::uint32_t index) {
    if (!is_leaf(index)) return make_node(slots_below(index));
    objects_.clear();
    gather(index);
    std::ranges::sort(objects_);
    const auto behind = std::ranges::unique(objects_);
    objects_.erase(behind.begin(), behind.end());
    return WideNode::leaf_bit | leaves_.make(objects_);
  }

  void gather(std::uint32_t index) {
    const Node& node = tree_.nodes[index];
    if (node.is_leaf()) {
      const auto objects = tree_.objects_of(node);
      objects_.insert(objects_.end(), objects.begin(), objects.end());
      return;
    }
    gather(node.left());
    gather(node.right());
  }

  const Tree& tree_;
  const std::span<const Aabb> boxes_;
  const WideLeaves& leaves_;
  const std::stop_token stop_;
  std::vector<Part> parts_;             // by node
  std::vector<std::uint32_t> objects_;  // of the leaf that is made
  WideTree wide_;
};

}  // namespace

std::optional<WideTree> make_wide_tree(const Tree& tree, std::span<const Aabb> boxes,
                                       const WideLeaves& leaves, std::stop_token stop) {
  return Widener(tree, boxes, leaves, std::move(stop)).make();
}

}  // namespace bspview
