#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <iterator>
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

/// What the inner nodes of a tree hold, kept while it is built: any of them can then be made a
/// leaf. The lists come in the order of the nodes, each behind its length.
class InnerLists {
 public:
  std::size_t size() const { return lists_.size(); }

  /// Object ids of the node with the i-th pair of children.
  std::span<const std::uint32_t> operator[](std::size_t i) const {
    return {lists_[i] + 1, *lists_[i]};
  }

  template <class Objects>
  void keep(const Objects& objects, InnerMeter& meter) {
    const std::size_t count = objects.count();
    if (!meter.complete() || !make_room(count + 1, meter)) return;
    References& page = pages_.back();
    lists_.push_back(page.data() + page.size());
    page.push_back(static_cast<std::uint32_t>(count));
    objects.append_objects(page);
  }

  /// Puts the lists of `part`, which becomes empty, behind these.
  void append(InnerLists& part) {
    lists_.insert(lists_.end(), part.lists_.begin(), part.lists_.end());
    std::ranges::move(part.pages_, std::back_inserter(pages_));
    metered_ += part.metered_;
    part = {};
  }

 private:
  /// Elements of a page stay where they are.
  bool make_room(std::size_t count, InnerMeter& meter) {
    constexpr std::size_t least = std::size_t{1} << 10, most = std::size_t{1} << 16;
    if (!pages_.empty() && pages_.back().capacity() - pages_.back().size() >= count) return true;
    const std::size_t grown = pages_.empty() ? least : 2 * pages_.back().capacity();
    const std::size_t size = std::max(count, std::clamp(grown, least, most));
    const std::size_t pointers = lists_.size() - std::exchange(metered_, lists_.size());
    if (!meter.admit(size * sizeof(std::uint32_t) + pointers * sizeof(lists_[0]))) return false;
    pages_.emplace_back().reserve(size);
    return true;
  }

  std::vector<References> pages_;
  std::vector<const std::uint32_t*> lists_;
  std::size_t metered_ = 0;  // lists whose pointers the meter knows of
};

/// The inner objects of one tree.
struct InnerObjects {
  explicit InnerObjects(InnerLimit limit) : meter(limit) {}
  InnerMeter meter;
  InnerLists lists;
};

}  // namespace bspview
