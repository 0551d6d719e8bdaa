#pragma once

#include <hwy/targets.h>

#include <cstdint>
#include <vector>

namespace bspview::test {

/// Those that the processor has and the kernels are compiled for.
inline std::vector<std::int64_t> instruction_sets() {
  std::vector<std::int64_t> sets;
  for (std::int64_t rest = hwy::SupportedTargets(); rest != 0; rest &= rest - 1) {
    sets.push_back(rest & -rest);
  }
  return sets;
}

/// Kernels use one set as long as it lives, then all again.
class OneInstructionSet {
 public:
  explicit OneInstructionSet(std::int64_t set) { use(set); }
  ~OneInstructionSet() { use(0); }
  OneInstructionSet(const OneInstructionSet&) = delete;
  OneInstructionSet& operator=(const OneInstructionSet&) = delete;

 private:
  static void use(std::int64_t set) {
    hwy::SetSupportedTargetsForTest(set);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

}  // namespace bspview::test
