// Replaces operator new and delete for the whole program.

#include "tests/memory/allocations.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

constexpr long never = -1;

std::atomic<std::ptrdiff_t> live = 0;
std::atomic<long> made = 0;
std::atomic<long> failing = never;  // number of the call that fails

void* allocate(std::size_t size, std::size_t alignment) {
  if (made.fetch_add(1) == failing.load()) throw std::bad_alloc();
  void* const memory = std::aligned_alloc(alignment, (size + alignment) / alignment * alignment);
  if (!memory) throw std::bad_alloc();
  live += static_cast<std::ptrdiff_t>(::malloc_usable_size(memory));
  return memory;
}

void release(void* memory) {
  if (!memory) return;
  live -= static_cast<std::ptrdiff_t>(::malloc_usable_size(memory));
  std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) {
  return allocate(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
  release(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  release(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  release(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  release(memory);
}

namespace bspview::test {

std::ptrdiff_t live_bytes() {
  return live;
}

FailingAllocation::FailingAllocation(long n) {
  made = 0;
  failing = n;
}
FailingAllocation::~FailingAllocation() {
  failing = never;
}
long FailingAllocation::calls() const {
  return made;
}

}  // namespace bspview::test
