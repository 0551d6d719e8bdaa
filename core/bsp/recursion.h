#pragma once

#include <optional>

#include "core/base/parallel.h"
#include "core/bsp/branch.h"
#include "core/bsp/build_job.h"
#include "core/bsp/few_parts.h"

namespace bspview {

/// The recursion that all builders share: limits, memory, threads and the order of the nodes.
/// `Objects` is a set of object parts that a rule looks at and a plane divides:
///
///     std::size_t count() const;
///     void write_objects(std::uint32_t* to) const;               ascending ids
///     std::optional<Split> find_split(const Place&) const;
///     Objects split(const CellSplit&, ScratchStack&);            keeps the larger side
///     void release();                                            the objects are needed no more
///     double tests() const;                                      optional: their cost, in C_I
///     FewParts few_parts(ScratchStack&) const;                   optional: of at most
///     FewParts::most
///     std::span<const ObjectPart> parts() const;                 optional: nodes can be put off
template <class Objects>
class Recursion {
 public:
  explicit Recursion(const BuildJob& job) : job_(job) {}

  void grow_root(Objects& objects, Branch& branch) const {
    branch.nodes.push_back(Node::make_leaf(0, 0));
    const double first = job_.progress ? BuildProgress::first_share(objects.count()) : 1.0;
    job_.tell(first);
    grow(objects, {job_.box, job_.depth, 1.0 - first}, {branch, 0});
    meter(job_, branch);
  }

 private:
  template <class>
  friend class Recursion;

  struct Slot {
    Branch& branch;
    std::uint32_t node;
  };
  struct Child {
    Objects& objects;
    Place place;
    bool moved = false;  ///< out of the parent's memory
  };

  // Bytes after which a branch tells the meter.
  static constexpr std::size_t meter_step = std::size_t{1} << 16;

  void grow(Objects& objects, const Place& place, Slot slot) const {
    if (place.work > 0.0 && !job_.progress->tells_apart(objects.count())) {
      grow(objects, {place.cell, place.depth}, slot);
      return job_.tell(place.work);
    }
    if constexpr (requires { objects.parts(); }) {
      if (is_put_off(objects.count(), place)) return defer(objects, place, slot);
    }
    if constexpr (requires { objects.few_parts(slot.branch.scratch); }) {
      if (objects.count() <= FewParts::most) {
        FewParts few = objects.few_parts(slot.branch.scratch);
        return Recursion<FewParts>(job_).grow(few, place, {slot.branch, slot.node});
      }
    }
    job_.poll();
    const std::optional<Split> wanted = wanted_split(objects, place);
    // To go on after a split that does not pay, in the hope of better ones below, measures worse:
    // it more than doubles the tree, and even where that is taken back it saves 1 % of the cost.
    // In float, as it is kept: a cut is to decide alike.
    const float saving = wanted ? static_cast<float>(leaf_tests(objects) - wanted->tests) : 0.0f;
    if (!wanted || saving < job_.costs.least_saving()) {
      make_leaf(objects, slot);
      return job_.tell(place.work);
    }
    if (job_.inner) keep_inner(objects, saving, slot.branch);

    const CellSplit split(*wanted, place.cell);
    Objects other = objects.split(split, slot.branch.scratch);
    const bool keeps_left = split.keeps_left();
    const int depth = place.depth + 1;
    const WorkShares work = deal_work(place, split);
    const Child left{
        keeps_left ? objects : other, {split.cells.left, depth, work.left}, !keeps_left};
    const Child right{keeps_left ? other : objects, {split.cells.right, depth, work.right}};
    grow_children(left, right, add_children(split, slot));
  }

  /// The split that the rule asks for and the limits allow.
  std::optional<Split> wanted_split(const Objects& objects, const Place& place) const {
    if (objects.count() <= job_.leaf_size || place.depth >= job_.max_depth) return {};
    return objects.find_split(place);
  }

  double leaf_tests(const Objects& objects) const {
    if constexpr (requires { objects.tests(); }) {
      return objects.tests();
    } else {
      return static_cast<double>(objects.count());
    }
  }

  bool is_put_off(std::size_t objects, const Place& place) const {
    return objects <= job_.deferred_size && objects > job_.leaf_size &&
           place.depth < job_.max_depth;
  }

  void defer(const Objects& objects, const Place& place, Slot slot) const {
    const auto parts = objects.parts();
    slot.branch.deferred.push_back({slot.node, place, {parts.begin(), parts.end()}});
    make_leaf(objects, slot);
  }

  void make_leaf(const Objects& objects, Slot slot) const {
    References& references = slot.branch.references;
    const auto first = static_cast<std::uint32_t>(references.size());
    make_room(job_, references, objects.count());
    const auto count = static_cast<std::uint32_t>(objects.count());
    references.resize(first + count);
    objects.write_objects(references.data() + first);
    slot.branch.nodes[slot.node] = Node::make_leaf(first, count);
    if (slot.branch.bytes() > slot.branch.metered + meter_step) meter(job_, slot.branch);
  }

  void keep_inner(const Objects& objects, float saving, Branch& branch) const {
    make_room(job_, branch.inner.lists(), 1);
    branch.inner.keep(objects, saving, job_.inner->meter, job_.inner->store);
  }

  /// The work of the children, once that of the node is done.
  WorkShares deal_work(const Place& place, const Split& split) const {
    if (place.work == 0.0) return {};
    const WorkShares work = BuildProgress::deal(place.work, split.left, split.right);
    job_.tell(work.own);
    return work;
  }

  /// Makes the node at `slot` an inner one; the result is the place of its left child.
  Slot add_children(const Split& split, Slot slot) const {
    Nodes& nodes = slot.branch.nodes;
    make_room(job_, nodes, 2);
    const auto left = static_cast<std::uint32_t>(nodes.size());
    nodes[slot.node] = Node::make_inner(split.axis, split.position, left);
    nodes.resize(left + 2);  // written when they are grown
    return {slot.branch, left};
  }

  void grow_children(const Child& left, const Child& right, Slot left_slot) const {
    const Slot right_slot{left_slot.branch, left_slot.node + 1};
    if (std::min(left.objects.count(), right.objects.count()) < job_.task_count) {
      grow(left.objects, left.place, left_slot);
      if (left.moved) left.objects.release();
      grow(right.objects, right.place, right_slot);
      return;
    }
    Branch beside;
    beside.nodes.push_back(Node::make_leaf(0, 0));
    beside.metered = sizeof(Node);  // it takes the place of a node that is there already
    const auto grow_right = [&] {
      grow(right.objects, right.place, {beside, 0});
      meter(job_, beside);
    };
    parallel_invoke([&] { grow(left.objects, left.place, left_slot); }, grow_right);
    splice(job_, right_slot.branch, right_slot.node, beside);
  }

  const BuildJob& job_;
};

}  // namespace bspview
