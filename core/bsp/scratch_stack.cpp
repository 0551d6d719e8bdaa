#include "core/bsp/scratch_stack.h"

#include <algorithm>

namespace bspview {

void* ScratchStack::take(std::size_t bytes) {
  constexpr std::size_t alignment = 16;
  constexpr std::size_t smallest_block = std::size_t{1} << 16;

  bytes = (bytes + alignment - 1) / alignment * alignment;
  if (blocks_.empty() || blocks_[top_.block].size() - top_.used < bytes) {
    const std::size_t next = blocks_.empty() ? 0 : top_.block + 1;
    if (next == blocks_.size() || blocks_[next].size() < bytes) {
      const std::size_t twice = next == 0 ? 0 : 2 * blocks_[next - 1].size();
      blocks_.resize(next);
      blocks_.emplace_back().resize(std::max({bytes, twice, smallest_block}));
    }
    top_ = {next, 0};
  }
  std::byte* const first = blocks_[top_.block].data() + top_.used;
  top_.used += bytes;
  return first;
}

}  // namespace bspview
