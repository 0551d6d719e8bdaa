#include "core/bsp/scratch_stack.h"

#include <algorithm>

namespace bspview {

void ScratchStack::go_to_next_block(std::size_t bytes) {
  constexpr std::size_t smallest_block = std::size_t{1} << 16;
  const std::size_t next = blocks_.empty() ? 0 : top_.block + 1;
  if (next == blocks_.size() || blocks_[next].size() < bytes) {
    const std::size_t twice = next == 0 ? 0 : 2 * blocks_[next - 1].size();
    blocks_.resize(next);
    blocks_.emplace_back().resize(std::max({bytes, twice, smallest_block}));
  }
  top_ = {next, 0};
}

}  // namespace bspview
