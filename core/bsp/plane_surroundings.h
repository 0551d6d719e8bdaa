#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/bsp/build_job.h"

namespace bspview {

/// Sides of boxes, in any order, as long as they are few.
class FewSides {
 public:
  void add(float side) {
    if (count_ < most) sides_[count_] = side;
    ++count_;
  }
  void add(const FewSides& others) {
    std::ranges::for_each(others.kept(), [&](float side) { add(side); });
    if (!others.are_all()) count_ = std::max(count_, most + 1);
  }
  void sort() { std::ranges::sort(std::span(sides_).first(kept().size())); }

  bool are_all() const { return count_ <= most; }
  std::span<const float> kept() const { return std::span(sides_).first(std::min(count_, most)); }

 private:
  static constexpr std::size_t most = 128;

  std::size_t count_ = 0;
  std::array<float, most> sides_;
};

/// What lies around a plane between two bins: how many boxes touch it from either side, the nearest
/// sides of boxes, and all in the two bins if they are few.
class PlaneSurroundings {
 public:
  /// `width` of a bin.
  PlaneSurroundings(const BuildJob& job, const Aabb& cell, const Split& plane, float width);

  void count(std::span<const ObjectPart> parts);
  void add(const PlaneSurroundings& other);

  /// The plane, or one beside a side of a box where that is cheaper. Its tests are infinite when
  /// the cell has no room for any of them.
  Split cheapest();

 private:
  class Best;

  void try_few_sides(Best& best);
  void try_nearest_sides(Best& best) const;

  const BuildJob& job_;
  const Aabb& cell_;
  const Split plane_;
  const float first_, last_;                                    // of the places in the two bins
  float below_, above_;                                         // the nearest sides
  std::uint32_t left_ = 0, right_ = 0, starts_ = 0, ends_ = 0;  // at the plane
  std::uint32_t before_ = 0, behind_ = 0;  // that begin before the two bins, and end behind them
  FewSides los_, his_;
};

}  // namespace bspview
