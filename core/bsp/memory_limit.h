#pragma once

#include <atomic>
#include <cstddef>

namespace bspview {

/// Thrown, inside the builders only, when a tree passes the memory limit.
struct MemoryLimitPassed {};

/// Counts the bytes of a whole tree, from any thread. Whether they pass the limit does not depend
/// on the order in which the tree is built.
class MemoryMeter {
 public:
  explicit MemoryMeter(std::size_t limit) : limit_(limit) {}

  void add(std::size_t bytes) {
    if (bytes_.fetch_add(bytes, std::memory_order_relaxed) + bytes > limit_) {
      throw MemoryLimitPassed{};
    }
  }

 private:
  const std::size_t limit_;
  std::atomic<std::size_t> bytes_ = 0;
};

}  // namespace bspview
