#pragma once

#include <string>
#include <vector>

#include "core/bsp/build.h"

namespace bspview::test {

/// Objects that are their own boxes: clipping one gives the overlap.
class BoxSet {
 public:
  BoxSet() = default;
  explicit BoxSet(std::vector<Aabb> boxes) : boxes_(std::move(boxes)) {}

  /// The input keeps pointing into this set.
  BuildInput input() const {
    return {boxes_, [this](std::uint32_t object, const Aabb& cell) {
              return intersection(boxes_[object], cell);
            }};
  }
  const std::vector<Aabb>& boxes() const { return boxes_; }
  std::size_t size() const { return boxes_.size(); }

 private:
  std::vector<Aabb> boxes_;
};

/// Small boxes all over a cube of side 2.
BoxSet random_boxes(int count, std::uint64_t seed);

/// What builders find hard.
struct HardCase {
  std::string name;
  BoxSet set;
};

/// `count` boxes each: identical, concentric, collinear, needles, flat on one axis, all in one
/// plane, touching in a grid, at huge coordinates, denormal, and with unusable ones in between.
std::vector<HardCase> hard_cases(int count, std::uint64_t seed);

}  // namespace bspview::test
