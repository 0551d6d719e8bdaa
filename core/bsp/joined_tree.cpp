#include "core/bsp/joined_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/bsp/object_groups.h"
#include "core/shape/triangle.h"

namespace bspview {
namespace {

/// The objects below a node while they can be one leaf.
class FewObjects {
 public:
  std::span<const std::uint32_t> ids() const { return std::span(ids_).first(size_); }

  /// Instead of what it holds; not more than there is room for, each once.
  void assign(std::span<const std::uint32_t> objects) {
    std::ranges::copy(objects, ids_.begin());
    size_ = objects.size();
  }

  /// All that it does not hold yet, or nothing if there is no room for them; says which.
  bool add(const FewObjects& others) {
    const std::size_t before = size_;
    for (const std::uint32_t object : others.ids()) {
      if (holds(object)) continue;
      if (size_ == most_joined_objects) {
        while (size_ > before) ids_[--size_] = none;
        return false;
      }
      ids_[size_++] = object;
    }
    return true;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;

  bool holds(std::uint32_t object) const {
    unsigned found = 0;  // without branches: which of them it is cannot be foretold
    for (const std::uint32_t id : ids_) found |= id == object ? 1u : 0u;
    return found != 0;
  }

  std::array<std::uint32_t, most_joined_objects> ids_{none, none, none, none,
                                                      none, none, none, none};
  std::size_t size_ = 0;
};

/// What was found below a node: nothing, a leaf that may be joined with others, or a node.
struct Below {
  enum class What { nothing, few, node } what = What::nothing;
  Aabb box;
  FewObjects few;
  std::uint32_t node = 0;
};

/// Goes through a branch and adds what it finds to a tree.
class Joiner {
 public:
  Joiner(const Tree& tree, std::span<const WideObject> objects, const std::stop_token& stop,
         JoinedTree& joined)
      : tree_(tree), objects_(objects), stop_(stop), joined_(joined) {}

  /// Finds what is below a node. `cell` is as before afterwards.
  void descend(std::uint32_t index, Aabb& cell, Below& below) {
    if (stop_.stop_requested()) return;
    const Node& node = tree_.nodes[index];
    if (node.is_leaf()) return look_at_leaf(node, cell, below);
    const int axis = node.axis();
    const float hi = std::exchange(cell.hi[axis], node.split());
    descend(node.left(), cell, below);
    cell.hi[axis] = hi;
    const float lo = std::exchange(cell.lo[axis], node.split());
    Below right;
    descend(node.right(), cell, right);
    cell.lo[axis] = lo;
    join(below, right);
  }

  /// Makes what is left of a plane what is on both sides of it.
  void join(Below& left, const Below& right) {
    if (right.what == Below::What::nothing) return;
    if (left.what == Below::What::nothing) {
      left = right;
      return;
    }
    const bool are_few = left.what == Below::What::few && right.what == Below::What::few;
    if (!are_few || !left.few.add(right.few)) {
      const std::uint32_t nodes[2] = {to_node(left), to_node(right)};
      left.box.grow(right.box);
      left.node = add_inner(left.box, nodes[0], nodes[1]);
      left.what = Below::What::node;
    } else {
      left.box.grow(right.box);
    }
  }

  std::uint32_t to_node(const Below& below) {
    if (below.what == Below::What::node) return below.node;
    const auto ids = below.few.ids();
    const std::uint32_t node = add_leaf(below.box, ids);
    std::sort(joined_.objects.end() - std::ssize(ids), joined_.objects.end());
    return node;
  }

 private:
  void look_at_leaf(const Node& leaf, const Aabb& cell, Below& below) {
    const auto ids = tree_.objects_of(leaf);
    if (ids.empty()) return;
    bool may_join = ids.size() <= most_joined_objects;
    for (const std::uint32_t id : ids) {
      const Aabb part = intersection(objects_[id].box, cell);
      if (!part.empty()) below.box.grow(part);
      may_join = may_join && objects_[id].joins;
    }
    if (below.box.empty()) return;
    if (may_join) {
      below.what = Below::What::few;
      below.few.assign(ids);
    } else {
      below.what = Below::What::node;
      below.node = ids.size() <= ObjectGroups::most_objects ? add_groups(ids, cell)
                                                            : add_leaf(below.box, ids);
    }
  }

  std::uint32_t add_groups(std::span<const std::uint32_t> ids, const Aabb& cell) {
    groups_.clear();
    for (const std::uint32_t id : ids) {
      const WideObject& object = objects_[id];
      const Aabb box = object.triangle ? clip_triangle(object.triangle, object.box, cell)
                                       : intersection(object.box, cell);
      if (!box.empty()) groups_.add(id, box, object.joins);
    }
    return add_group(groups_.sort(), ObjectGroups::most_levels);
  }

  std::uint32_t add_group(ObjectGroups::Range group, int levels) {
    const Aabb box = groups_.box(group);
    const auto place = levels > 0 ? groups_.split(group) : std::nullopt;
    if (place) {
      const std::uint32_t first = add_group({group.first, *place}, levels - 1);
      return add_inner(box, first, add_group({*place, group.last}, levels - 1));
    }
    std::array<std::uint32_t, ObjectGroups::most_objects> ids;
    const std::span<std::uint32_t> some = std::span(ids).first(group.size());
    for (std::size_t i = 0; i < some.size(); ++i) some[i] = groups_.id(group.first + i);
    std::ranges::sort(some);
    return add_leaf(box, some);
  }

  std::uint32_t add_leaf(const Aabb& box, std::span<const std::uint32_t> ids) {
    const auto first = static_cast<std::uint32_t>(joined_.objects.size());
    joined_.objects.insert(joined_.objects.end(), ids.begin(), ids.end());
    const auto count = static_cast<std::uint32_t>(ids.size());
    JoinedNode leaf{box, 0, first, count, {}};
    const auto steps = static_cast<float>((count + most_joined_objects - 1) / most_joined_objects);
    std::ranges::fill(leaf.cost, half_area(box) * steps);
    return add(leaf);
  }
  std::uint32_t add_inner(const Aabb& box, std::uint32_t left, std::uint32_t right) {
    const JoinedNode &a = joined_.nodes[left], &b = joined_.nodes[right];
    JoinedNode node{box, 1 + a.inner + b.inner, left, right, {}};
    node.cost[0] = half_area(box) + share_cells(a, b, WideNode::width).cost;
    for (int cells = 2; cells < WideNode::width; ++cells) {
      node.cost[cells - 1] = std::min(node.cost[cells - 2], share_cells(a, b, cells).cost);
    }
    return add(node);
  }
  std::uint32_t add(const JoinedNode& node) {
    joined_.nodes.push_back(node);
    return static_cast<std::uint32_t>(joined_.nodes.size() - 1);
  }

  const Tree& tree_;
  const std::span<const WideObject> objects_;
  const std::stop_token& stop_;
  JoinedTree& joined_;
  ObjectGroups groups_;
};

/// A branch that one thread goes through.
struct Task {
  std::uint32_t root = 0;
  Aabb cell;
  Below below;
  JoinedTree joined;
  std::uint32_t first_node = 0, first_object = 0;  ///< in the whole
};

/// Leaves the branches below the first levels to many threads.
class TreeJoiner {
 public:
  TreeJoiner(const Tree& tree, std::span<const WideObject> objects, const std::stop_token& stop)
      : tree_(tree), objects_(objects), stop_(stop) {
    constexpr std::size_t worth_a_task = 512, most_tasks = 4096;  // nodes of the binary tree
    levels_ = std::bit_width(std::min(most_tasks, tree.nodes.size() / worth_a_task));
  }

  JoinedTree join() {
    plan(0, tree_.box, 0);
    for_each_task([&](Task& task) {
      Joiner(tree_, objects_, stop_, task.joined).descend(task.root, task.cell, task.below);
    });
    make_room();
    for_each_task([&](Task& task) { move_in(task); });
    if (stop_.stop_requested()) return {};
    auto next = tasks_.begin();
    Joiner top(tree_, objects_, stop_, whole_);
    const Below all = join_tasks(top, 0, 0, next);
    if (all.what == Below::What::few) top.to_node(all);
    return std::move(whole_);
  }

 private:
  void plan(std::uint32_t index, const Aabb& cell, int depth) {
    const Node& node = tree_.nodes[index];
    if (node.is_leaf() || depth == levels_) {
      tasks_.push_back({.root = index, .cell = cell});
      return;
    }
    const Cells cells = split_cell(cell, node.axis(), node.split());
    plan(node.left(), cells.left, depth + 1);
    plan(node.right(), cells.right, depth + 1);
  }

  /// What the tasks found, one after the other, in the order of plan().
  Below join_tasks(Joiner& top, std::uint32_t index, int depth, std::vector<Task>::iterator& next) {
    const Node& node = tree_.nodes[index];
    if (node.is_leaf() || depth == levels_) return (next++)->below;
    Below left = join_tasks(top, node.left(), depth + 1, next);
    top.join(left, join_tasks(top, node.right(), depth + 1, next));
    return left;
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
      nodes += task.joined.nodes.size();
      objects += task.joined.objects.size();
    }
    // Every task may be a leaf yet, and every join of two makes a node.
    whole_.nodes.reserve(nodes + 2 * tasks_.size());
    whole_.objects.reserve(objects + most_joined_objects * tasks_.size());
    whole_.nodes.resize(nodes);
    whole_.objects.resize(objects);
  }

  void move_in(Task& task) {
    JoinedNode* to = whole_.nodes.data() + task.first_node;
    for (JoinedNode node : task.joined.nodes) {
      node.first += node.is_leaf() ? task.first_object : task.first_node;
      if (!node.is_leaf()) node.other += task.first_node;
      *to++ = node;
    }
    std::ranges::copy(task.joined.objects, whole_.objects.data() + task.first_object);
    task.below.node += task.first_node;
    task.joined = {};
  }

  const Tree& tree_;
  const std::span<const WideObject> objects_;
  const std::stop_token& stop_;
  int levels_;  // above the tasks
  std::vector<Task> tasks_;
  JoinedTree whole_;
};

}  // namespace

CellShares share_cells(const JoinedNode& left, const JoinedNode& right, int cells) {
  CellShares best{std::numeric_limits<float>::infinity(), 1};
  for (int i = 1; i < cells; ++i) {
    const float cost = left.cost[i - 1] + right.cost[cells - i - 1];
    if (cost < best.cost) best = {cost, i};
  }
  return best;
}

JoinedTree join_leaves(const Tree& tree, std::span<const WideObject> objects,
                       const std::stop_token& stop) {
  return TreeJoiner(tree, objects, stop).join();
}

}  // namespace bspview
