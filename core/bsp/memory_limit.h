#pragma once

// The bytes of nodes and references are limited in two rounds, neither of which depends on the
// order in which the tree is built. The first counts all that is built and is given up once the
// limit is passed. Then the second shares the limit out, from the root down.

#include <atomic>
#include <cstddef>

namespace bspview {

/// Thrown, inside the builders only, when the tree of the first round passes the limit.
struct MemoryLimitPassed {};

/// Counts the bytes of a whole tree, from any thread.
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

/// Whether a node that may take `memory` bytes has room for two children with so many objects.
bool has_room(std::size_t memory, std::size_t left_objects, std::size_t right_objects);

/// Bytes that the children of a node with `memory` bytes may take: each what it needs as a leaf,
/// and what is left over in proportion to its objects.
struct ChildMemory {
  std::size_t left = 0, right = 0;
};
ChildMemory share_memory(std::size_t memory, std::size_t left_objects, std::size_t right_objects);

}  // namespace bspview
