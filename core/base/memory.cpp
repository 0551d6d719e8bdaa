#include "core/base/memory.h"

#include <cstdlib>  // defines __GLIBC__
#include <new>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#ifdef __linux__
#include <sys/mman.h>
#endif

namespace bspview {

void give_memory_back() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

#ifdef __linux__

namespace {

/// Linux places whole huge pages so that none is cut.
std::size_t whole_pages(std::size_t bytes) {
  constexpr std::size_t huge_page = std::size_t{1} << 21;
  return (bytes + huge_page - 1) / huge_page * huge_page;
}

}  // namespace

void* allocate_pages(std::size_t bytes) {
  const std::size_t size = whole_pages(bytes);
  if (size < bytes) throw std::bad_alloc();
  void* const first =
      mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (first == MAP_FAILED) throw std::bad_alloc();
  madvise(first, size, MADV_HUGEPAGE);  // where there are none, nothing is lost
  return first;
}

void free_pages(void* first, std::size_t bytes) noexcept {
  munmap(first, whole_pages(bytes));
}

#else

void* allocate_pages(std::size_t bytes) {
  return ::operator new(bytes);
}

void free_pages(void* first, std::size_t) noexcept {
  ::operator delete(first);
}

#endif

}  // namespace bspview
