#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

#include "core/base/memory.h"

namespace bspview {

/// Leaves new elements as they come from memory: whoever makes room writes all of them. Large
/// arrays come in pages.
template <class T>
struct RawAllocator : std::allocator<T> {
  static_assert(std::is_trivially_copyable_v<T>);

  template <class Other>
  struct rebind {
    using other = RawAllocator<Other>;
  };

  T* allocate(std::size_t count) {
    if (count < fewest_in_pages) return std::allocator<T>::allocate(count);
    return static_cast<T*>(allocate_pages(count * sizeof(T)));
  }
  void deallocate(T* first, std::size_t count) noexcept {
    if (count < fewest_in_pages) return std::allocator<T>::deallocate(first, count);
    free_pages(first, count * sizeof(T));
  }

  void construct(T*) {}
  void construct(T* place, const T& value) { std::construct_at(place, value); }

 private:
  static constexpr std::size_t fewest_in_pages = (fewest_page_bytes + sizeof(T) - 1) / sizeof(T);
};

/// A vector whose resize() costs nothing an element, so that many threads can fill it: they, not
/// the one that makes room, are the first to touch its memory.
template <class T>
using RawVector = std::vector<T, RawAllocator<T>>;

}  // namespace bspview
