#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/raw_vector.h"

namespace bspview {

/// Memory that is given back in the reverse order of its allocation: a recursion takes what it
/// needs without going to the heap for every node.
class ScratchStack {
  /// A height of the stack.
  struct Mark {
    std::size_t block = 0;
    std::size_t used = 0;  // bytes of it
  };

 public:
  /// An array that goes back to its stack when it dies. Its elements start undefined.
  template <class T>
  class Array {
    static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= 16);

   public:
    Array(ScratchStack& stack, std::size_t size)
        : stack_(&stack),
          mark_(stack.top_),
          first_(static_cast<T*>(stack.take(size * sizeof(T)))) {}
    Array(Array&& other) noexcept
        : stack_(std::exchange(other.stack_, nullptr)), mark_(other.mark_), first_(other.first_) {}
    ~Array() { release(); }
    Array& operator=(Array&&) = delete;

    /// As if it died.
    void release() {
      if (stack_) stack_->top_ = mark_;
      stack_ = nullptr;
    }

    T* data() const { return first_; }
    T& operator[](std::size_t i) const { return first_[i]; }

   private:
    ScratchStack* stack_;
    Mark mark_;
    T* first_;
  };

  /// Arrays on top of the stack that go back to it together when the pile dies. Nothing else may
  /// lie between them.
  class Pile {
   public:
    explicit Pile(ScratchStack& stack) : stack_(&stack), mark_(stack.top_) {}
    Pile(Pile&& other) noexcept
        : stack_(std::exchange(other.stack_, nullptr)), mark_(other.mark_) {}
    ~Pile() {
      if (stack_) stack_->top_ = mark_;
    }
    Pile& operator=(Pile&&) = delete;

    /// Its elements start undefined.
    template <class T>
    T* take(std::size_t size) {
      static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= 16);
      return static_cast<T*>(stack_->take(size * sizeof(T)));
    }

   private:
    ScratchStack* stack_;
    Mark mark_;
  };

  ScratchStack() = default;
  ScratchStack(const ScratchStack&) = delete;
  ScratchStack& operator=(const ScratchStack&) = delete;

 private:
  void* take(std::size_t bytes) {
    constexpr std::size_t alignment = 16;
    bytes = (bytes + alignment - 1) / alignment * alignment;
    if (blocks_.empty() || blocks_[top_.block].size() - top_.used < bytes) go_to_next_block(bytes);
    std::byte* const first = blocks_[top_.block].data() + top_.used;
    top_.used += bytes;
    return first;
  }
  void go_to_next_block(std::size_t bytes);

  // Those before the top one are full, those behind it are free.
  std::vector<RawVector<std::byte>> blocks_;
  Mark top_;
};

}  // namespace bspview
