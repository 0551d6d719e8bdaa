#include "core/bsp/grouped_tree.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/bsp/object_groups.h"

namespace bspview {
namespace {

/// Index of a node, or nothing where nothing is.
using NodeIndex = std::optional<std::uint32_t>;

/// Puts the references below a node behind those of `few`; false where they become too many, or
/// may not be dealt out.
bool gather_few(const Tree& tree, const WideObjects& objects, std::uint32_t index,
                std::vector<std::uint32_t>& few) {
  const Node& node = tree.nodes[index];
  if (!node.is_leaf()) {
    return gather_few(tree, objects, node.left(), few) &&
           gather_few(tree, objects, node.right(), few);
  }
  const auto ids = tree.objects_of(node);
  if (few.size() + ids.size() > ObjectGroups::most_objects) return false;
  if (ids.size() == 1 && objects.list[ids[0]].is_alone) return false;
  few.insert(few.end(), ids.begin(), ids.end());
  return true;
}

/// Goes through a branch and adds what it finds to a tree.
class Grouper {
 public:
  Grouper(const Tree& tree, const WideObjects& objects, const std::stop_token& stop,
          GroupedTree& grouped)
      : tree_(tree), objects_(objects), stop_(stop), grouped_(grouped), groups_(grouped.unit) {}

  /// What is below a node. `cell` is as before afterwards.
  NodeIndex descend(std::uint32_t index, Aabb& cell) {
    if (stop_.stop_requested()) return {};
    const Node& node = tree_.nodes[index];
    few_.clear();
    if (!gather_few(tree_, objects_, index, few_)) {
      return node.is_leaf() ? add_whole_leaf(tree_.objects_of(node), cell) : divide(node, cell);
    }
    const NodeIndex groups = add_few(cell);
    if (!groups || node.is_leaf() || !(steps_below(*groups) > dear)) return groups;
    const std::size_t nodes = grouped_.nodes.size(), objects = grouped_.objects.size();
    const NodeIndex cells = divide(node, cell);
    if (cells && cost(*cells) < cost(*groups)) return cells;  // what is dearer stays, out of reach
    grouped_.nodes.resize(nodes);
    grouped_.objects.resize(objects);
    return groups;
  }

  /// What is on both sides of a plane.
  NodeIndex join(NodeIndex left, NodeIndex right) {
    if (!left || !right) return left ? left : right;
    return add_inner(*left, *right);
  }

 private:
  /// Steps and tests of a ray that meets it: groups of objects that reach across each other may be
  /// worse than planes through them.
  static constexpr float dear = 12.0f;
  float steps_below(std::uint32_t node) const {
    return cost(node) / grouped_.area(grouped_.nodes[node].box);
  }
  float cost(std::uint32_t node) const { return grouped_.nodes[node].cost[0]; }

  NodeIndex divide(const Node& node, Aabb& cell) {
    const int axis = node.axis();
    const float hi = std::exchange(cell.hi[axis], node.split());
    const NodeIndex left = descend(node.left(), cell);
    cell.hi[axis] = hi;
    const float lo = std::exchange(cell.lo[axis], node.split());
    const NodeIndex right = descend(node.right(), cell);
    cell.lo[axis] = lo;
    return join(left, right);
  }

  NodeIndex add_few(const Aabb& cell) {
    std::ranges::sort(few_);
    few_.erase(std::ranges::unique(few_).begin(), few_.end());
    groups_.clear();
    for (const std::uint32_t id : few_) {
      if (stop_.stop_requested()) return {};
      const Aabb box = objects_.part(id, cell);
      if (!box.empty()) groups_.add(id, box, objects_.list[id].is_eighth);
    }
    if (groups_.size() == 0) return {};
    return add_group(groups_.sort(), ObjectGroups::most_levels);
  }

  std::uint32_t add_group(ObjectGroups::Range group, int levels) {
    if (const auto place = levels > 0 ? groups_.split(group) : std::nullopt) {
      const std::uint32_t first = add_group({group.first, *place}, levels - 1);
      return add_inner(first, add_group({*place, group.last}, levels - 1));
    }
    const auto first = grouped_.objects.size();
    for (std::size_t i = group.first; i < group.last; ++i) {
      grouped_.objects.push_back(groups_.id(i));
    }
    std::ranges::sort(std::span(grouped_.objects).subspan(first));
    return add_leaf(groups_.box(group), first);
  }

  NodeIndex add_whole_leaf(std::span<const std::uint32_t> ids, const Aabb& cell) {
    Aabb box;
    for (const std::uint32_t id : ids) {
      const Aabb part = intersection(objects_.list[id].box, cell);
      if (!part.empty()) box.grow(part);
    }
    if (box.empty()) return {};
    const auto first = grouped_.objects.size();
    grouped_.objects.insert(grouped_.objects.end(), ids.begin(), ids.end());
    return add_leaf(box, first);
  }

  /// Of all objects from `first` on.
  std::uint32_t add_leaf(const Aabb& box, std::size_t first) {
    const auto ids = std::span(grouped_.objects).subspan(first);
    GroupedNode leaf{
        box, 0, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(ids.size()), {}};
    ObjectTests tests;
    for (const std::uint32_t id : ids) tests.add(objects_.list[id].is_eighth);
    std::ranges::fill(leaf.cost, grouped_.area(box) * tests.cost());
    return add(leaf);
  }
  std::uint32_t add_inner(std::uint32_t left, std::uint32_t right) {
    const GroupedNode &a = grouped_.nodes[left], &b = grouped_.nodes[right];
    GroupedNode node{a.box, 1 + a.inner + b.inner, left, right, {}};
    node.box.grow(b.box);
    node.cost[0] = grouped_.area(node.box) + share_cells(a, b, WideNode::width).cost;
    for (int cells = 2; cells < WideNode::width; ++cells) {
      node.cost[cells - 1] = std::min(node.cost[cells - 2], share_cells(a, b, cells).cost);
    }
    return add(node);
  }
  std::uint32_t add(const GroupedNode& node) {
    grouped_.nodes.push_back(node);
    return static_cast<std::uint32_t>(grouped_.nodes.size() - 1);
  }

  const Tree& tree_;
  const WideObjects& objects_;
  const std::stop_token& stop_;
  GroupedTree& grouped_;
  std::vector<std::uint32_t> few_;  // references of a branch
  ObjectGroups groups_;
};

/// A branch that one thread goes through.
struct Task {
  std::uint32_t root = 0;
  Aabb cell;
  NodeIndex found;
  GroupedTree grouped;
  std::uint32_t first_node = 0, first_object = 0;  ///< in the whole
};

/// Leaves the branches below the first levels to many threads.
class TreeGrouper {
 public:
  TreeGrouper(const Tree& tree, const WideObjects& objects, const std::stop_token& stop)
      : tree_(tree), objects_(objects), stop_(stop) {
    constexpr std::size_t worth_a_task = 512, most_tasks = 4096;  // nodes of the binary tree
    levels_ = std::bit_width(std::min(most_tasks, tree.nodes.size() / worth_a_task));
  }

  GroupedTree group() {
    whole_.unit = area_unit(tree_.box);
    plan(0, tree_.box, 0);
    for_each_task([&](Task& task) {
      task.grouped.unit = whole_.unit;
      task.found = Grouper(tree_, objects_, stop_, task.grouped).descend(task.root, task.cell);
    });
    make_room();
    for_each_task([&](Task& task) { move_in(task); });
    if (stop_.stop_requested()) return {};
    auto next = tasks_.begin();
    Grouper top(tree_, objects_, stop_, whole_);
    join_tasks(top, 0, next);
    return std::move(whole_);
  }

 private:
  void plan(std::uint32_t index, const Aabb& cell, int depth) {
    if (is_task(index, depth)) {
      tasks_.push_back({.root = index, .cell = cell});
      return;
    }
    const Node& node = tree_.nodes[index];
    const Cells cells = split_cell(cell, node.axis(), node.split());
    plan(node.left(), cells.left, depth + 1);
    plan(node.right(), cells.right, depth + 1);
  }

  bool is_task(std::uint32_t index, int depth) {
    if (depth == levels_ || tree_.nodes[index].is_leaf()) return true;
    few_.clear();
    return gather_few(tree_, objects_, index, few_);
  }

  /// What the tasks found, one after the other, in the order of plan().
  NodeIndex join_tasks(Grouper& top, std::uint32_t index, std::vector<Task>::iterator& next) {
    if (next->root == index) return (next++)->found;
    const Node& node = tree_.nodes[index];
    const NodeIndex left = join_tasks(top, node.left(), next);
    return top.join(left, join_tasks(top, node.right(), next));
  }

  void for_each_task(const auto& work) {
    parallel_for(static_cast<int>(tasks_.size()), [&](int i) {
      if (!stop_.stop_requested()) work(tasks_[static_cast<std::size_t>(i)]);
    });
  }

  void make_room() {
    std::size_t nodes = 0, objects = 0;
    for (Task& task : tasks_) {
      task.first_node = static_cast<std::uint32_t>(nodes);
      task.first_object = static_cast<std::uint32_t>(objects);
      nodes += task.grouped.nodes.size();
      objects += task.grouped.objects.size();
    }
    whole_.nodes.reserve(nodes + tasks_.size());  // every join of two makes a node
    whole_.nodes.resize(nodes);
    whole_.objects.resize(objects);
  }

  void move_in(Task& task) {
    GroupedNode* to = whole_.nodes.data() + task.first_node;
    for (GroupedNode node : task.grouped.nodes) {
      node.first += node.is_leaf() ? task.first_object : task.first_node;
      if (!node.is_leaf()) node.other += task.first_node;
      *to++ = node;
    }
    std::ranges::copy(task.grouped.objects, whole_.objects.data() + task.first_object);
    if (task.found) *task.found += task.first_node;
    task.grouped = {};
  }

  const Tree& tree_;
  const WideObjects& objects_;
  const std::stop_token& stop_;
  int levels_;  // above the tasks
  std::vector<std::uint32_t> few_;
  std::vector<Task> tasks_;
  GroupedTree whole_;
};

}  // namespace

CellShares share_cells(const GroupedNode& left, const GroupedNode& right, int cells) {
  CellShares best{std::numeric_limits<float>::infinity(), 1};
  for (int i = 1; i < cells; ++i) {
    const float cost = left.cost[i - 1] + right.cost[cells - i - 1];
    if (cost < best.cost) best = {cost, i};
  }
  return best;
}

GroupedTree group_objects(const Tree& tree, const WideObjects& objects,
                          const std::stop_token& stop) {
  return TreeGrouper(tree, objects, stop).group();
}

}  // namespace bspview
