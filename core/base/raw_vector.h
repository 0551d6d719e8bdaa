#pragma once

#include <memory>
#include <type_traits>
#include <vector>

namespace bspview {

/// Leaves new elements as they come from memory: whoever makes room writes all of them.
template <class T>
struct RawAllocator : std::allocator<T> {
  static_assert(std::is_trivially_copyable_v<T>);

  template <class Other>
  struct rebind {
    using other = RawAllocator<Other>;
  };

  void construct(T*) {}
  void construct(T* place, const T& value) { std::construct_at(place, value); }
};

/// A vector whose resize() costs nothing an element, so that many threads can fill it: they, not
/// the one that makes room, are the first to touch its memory.
template <class T>
using RawVector = std::vector<T, RawAllocator<T>>;

}  // namespace bspview
