#pragma once

#include <oneapi/tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace bspview {

/// Thrown, inside the builders only, when a tree is wanted with its inner objects or not at all.
struct InnerObjectsPassed {};

/// How much may be kept of what inner nodes hold.
struct InnerLimit {
  enum class WhenPassed { build_without, do_not_build };
  std::size_t bytes = 0;
  WhenPassed when_passed = WhenPassed::build_without;
};

/// What the inner nodes of a tree hold, kept while it is built, from any thread: any of them can
/// then be made a leaf.
class InnerObjects {
 public:
  using List = std::span<const std::uint32_t>;  ///< object ids

  explicit InnerObjects(InnerLimit limit) : limit_(limit) {}

  /// Keeps the objects of one node, of which there are more than none.
  template <class Objects>
  List keep(const Objects& objects) {
    const std::size_t count = objects.count();
    if (!admit(sizeof(List) + count * sizeof(std::uint32_t))) return {};
    std::vector<std::uint32_t>& page = page_for(count);
    const std::size_t first = page.size();
    objects.append_objects(page);
    return List(page).subspan(first);
  }

  /// Whether there was room for all.
  bool complete() const { return bytes() <= limit_.bytes; }
  std::size_t bytes() const { return bytes_.load(std::memory_order_relaxed); }

  /// As if there were no room for any.
  void give_up() { (void)admit(limit_.bytes + 1); }

  /// The k-th is that of the inner node with the k-th pair of children; see Branch.
  std::vector<List> lists;

 private:
  using Pages = std::vector<std::vector<std::uint32_t>>;

  bool admit(std::size_t bytes) {
    if (complete()) bytes_.fetch_add(bytes, std::memory_order_relaxed);
    if (!complete() && limit_.when_passed == InnerLimit::WhenPassed::do_not_build) {
      throw InnerObjectsPassed{};
    }
    return complete();
  }

  /// A page of this thread with room for `count` more: its elements stay where they are.
  std::vector<std::uint32_t>& page_for(std::size_t count) {
    constexpr std::size_t page_size = std::size_t{1} << 16;
    Pages& pages = pages_.local();
    if (pages.empty() || pages.back().capacity() - pages.back().size() < count) {
      pages.emplace_back().reserve(std::max(count, page_size));
    }
    return pages.back();
  }

  const InnerLimit limit_;
  std::atomic<std::size_t> bytes_ = 0;
  tbb::enumerable_thread_specific<Pages> pages_;
};

}  // namespace bspview
