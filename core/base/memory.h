#pragma once

#include <cstddef>

namespace bspview {

/// Gives what was freed back to the system, where the heap would keep it for later. Takes about
/// 10 ms for 100 MB; call it when large things are gone for long.
void give_memory_back();

/// Arrays of at least as many bytes come from allocate_pages.
inline constexpr std::size_t fewest_page_bytes = std::size_t{1} << 20;

/// Memory straight from the system, in huge pages where there are any: small ones take a
/// microsecond each to touch and to give back, 25 ms for 100 MB. Throws std::bad_alloc.
[[nodiscard]] void* allocate_pages(std::size_t bytes);
void free_pages(void* first, std::size_t bytes) noexcept;

}  // namespace bspview
