#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "core/bsp/node.h"

namespace bspview {

/// Thrown, inside the builders only, when a tree is wanted with its inner objects or not at all.
struct InnerObjectsPassed {};

/// How much may be kept of what inner nodes hold.
struct InnerLimit {
  enum class WhenPassed { build_without, do_not_build };
  std::size_t bytes = 0;
  WhenPassed when_passed = WhenPassed::build_without;
};

/// Counts the bytes of all InnerLists of a tree, from any thread.
class InnerMeter {
 public:
  explicit InnerMeter(InnerLimit limit) : limit_(limit) {}

  /// Whether there was room for all.
  bool complete() const { return bytes() <= limit_.bytes; }
  std::size_t bytes() const { return bytes_.load(std::memory_order_relaxed); }

  bool admit(std::size_t bytes) {
    bytes_.fetch_add(bytes, std::memory_order_relaxed);
    if (!complete() && limit_.when_passed == InnerLimit::WhenPassed::do_not_build) {
      throw InnerObjectsPassed{};
    }
    return complete();
  }

  /// As if there were no room for any.
  void give_up() {
    if (complete()) (void)admit(limit_.bytes + 1 - bytes());
  }

 private:
  const InnerLimit limit_;
  std::atomic<std::size_t> bytes_ = 0;
};

/// Where the lists of a tree lie. Small parts of few large ones: to get memory from the system
/// takes longer than to fill it.
class InnerStore {
 public:
  /// Room for as many elements, from any thread. It lasts as long as the store.
  std::uint32_t* take(std::size_t count) {
    const std::lock_guard lock(mutex_);
    if (slabs_.empty() || slabs_.back().size() - used_ < count) add_slab(count);
    return slabs_.back().data() + std::exchange(used_, used_ + count);
  }

  /// All that was taken is gone.
  void clear() {
    const std::lock_guard lock(mutex_);
    slabs_ = {};
    used_ = 0;
  }

 private:
  void add_slab(std::size_t least) {
    constexpr std::size_t smallest = std::size_t{1} << 14, largest = std::size_t{1} << 20;
    const std::size_t grown = slabs_.empty() ? 0 : 2 * slabs_.back().size();
    References slab;
    slab.resize(std::max(least, std::clamp(grown, smallest, largest)));
    slabs_.push_back(std::move(slab));
    used_ = 0;
  }

  std::mutex mutex_;
  std::vector<References> slabs_;
  std::size_t used_ = 0;  // of the last one
};

/// What the inner nodes of a tree hold, kept while it is built: any of them can then be made a
/// leaf. The lists come in the order of the nodes, each behind its length and what its plane saves.
class InnerLists {
 public:
  using Lists = RawVector<const std::uint32_t*>;

  std::size_t size() const { return lists_.size(); }

  /// Object ids of the node with the i-th pair of children.
  std::span<const std::uint32_t> operator[](std::size_t i) const {
    return {lists_[i] + head, *lists_[i]};
  }
  /// Expected tests of a leaf in its place, less those of its children as leaves (see SplitTests);
  /// infinite where the rule knows no costs.
  float saving(std::size_t i) const { return std::bit_cast<float>(lists_[i][1]); }

  /// Where room is made, which takes its time, before more are kept.
  Lists& lists() { return lists_; }
  const Lists& lists() const { return lists_; }

  template <class Objects>
  void keep(const Objects& objects, float saving, InnerMeter& meter, InnerStore& store) {
    const std::size_t count = objects.count();
    if (!meter.complete() || !make_room(head + count, meter, store)) return;
    lists_.push_back(page_);
    page_[0] = static_cast<std::uint32_t>(count);
    page_[1] = std::bit_cast<std::uint32_t>(saving);
    objects.write_objects(page_ + head);
    page_ += head + count;
    room_ -= head + count;
  }

  /// Those of `part`, which becomes empty, have been put behind these.
  void take_over(InnerLists& part) {
    metered_ += part.metered_;
    part = {};
  }

 private:
  static constexpr std::size_t head = 2;

  bool make_room(std::size_t count, InnerMeter& meter, InnerStore& store) {
    constexpr std::size_t least = std::size_t{1} << 10, most = std::size_t{1} << 14;
    if (room_ >= count) return true;
    page_size_ = std::clamp(2 * page_size_, least, most);
    const std::size_t size = std::max(count, page_size_);
    const std::size_t pointers = lists_.size() - std::exchange(metered_, lists_.size());
    if (!meter.admit(size * sizeof(std::uint32_t) + pointers * sizeof(lists_[0]))) return false;
    page_ = store.take(size);
    room_ = size;
    return true;
  }

  Lists lists_;
  std::uint32_t* page_ = nullptr;  // where the next list goes
  std::size_t room_ = 0;           // there
  std::size_t page_size_ = 0;      // of the last page, but for a longer list
  std::size_t metered_ = 0;        // lists whose pointers the meter knows of
};

/// The inner objects of one tree.
struct InnerObjects {
  explicit InnerObjects(InnerLimit limit) : meter(limit) {}

  /// Before any list is kept: no list will be.
  void give_up() {
    meter.give_up();
    store.clear();
  }

  InnerMeter meter;
  InnerStore store;
  InnerLists lists;
};

}  // namespace bspview
