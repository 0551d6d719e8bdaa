#pragma once

#include <cstddef>

namespace bspview::test {

/// Bytes that operator new gave and that operator delete has not had back, on all threads.
std::ptrdiff_t live_bytes();

/// While it lives, the n-th call of operator new from now on, on any thread, throws std::bad_alloc.
class FailingAllocation {
 public:
  explicit FailingAllocation(long n);
  ~FailingAllocation();
  FailingAllocation(const FailingAllocation&) = delete;
  FailingAllocation& operator=(const FailingAllocation&) = delete;

  /// Calls since its construction, failed ones included.
  long calls() const;
};

}  // namespace bspview::test
