#include "core/bsp/plane_surroundings.h"

#include <algorithm>
#include <limits>

#include "core/math/float_error.h"

namespace bspview {

PlaneSurroundings::PlaneSurroundings(const BuildJob& job, const Aabb& cell, const Split& plane,
                                     float width)
    : job_(job),
      cell_(cell),
      plane_(plane),
      first_(plane.position - width),
      last_(plane.position + width),
      below_(component(cell.lo, plane.axis)),
      above_(component(cell.hi, plane.axis)) {}

void PlaneSurroundings::count(std::span<const ObjectPart> parts) {
  const int axis = plane_.axis;
  const float position = plane_.position, first = first_, last = last_;
  job_.for_each(parts.size(), light_steps, [&](std::size_t i) {
    const float lo = component(parts[i].box.lo, axis), hi = component(parts[i].box.hi, axis);
    left_ += lo <= position;
    right_ += hi >= position;
    starts_ += lo == position;
    ends_ += hi == position;
    below_ = std::max(below_, hi < position ? hi : lo < position ? lo : below_);
    above_ = std::min(above_, lo > position ? lo : hi > position ? hi : above_);
    before_ += lo < first;
    behind_ += hi > last;
    if (first <= lo && lo <= last) los_.add(lo);
    if (first <= hi && hi <= last) his_.add(hi);
  });
}

void PlaneSurroundings::add(const PlaneSurroundings& other) {
  left_ += other.left_;
  right_ += other.right_;
  starts_ += other.starts_;
  ends_ += other.ends_;
  below_ = std::max(below_, other.below_);
  above_ = std::min(above_, other.above_);
  before_ += other.before_;
  behind_ += other.behind_;
  los_.add(other.los_);
  his_.add(other.his_);
}

/// The cheapest of the planes that were tried, among equals the first.
class PlaneSurroundings::Best {
 public:
  Best(const BuildJob& job, const Aabb& cell, int axis)
      : range_(job, cell, axis),
        tests_(job.costs, cell, axis),
        split_{.axis = axis, .tests = std::numeric_limits<double>::infinity()} {}

  void try_plane(float position, std::uint32_t left, std::uint32_t right) {
    const double tests = tests_.divided(position, position, left, right);
    if (!range_.holds(position) || !(tests < split_.tests)) return;
    split_ = {split_.axis, position, left, right, tests};
  }
  const Split& split() const { return split_; }

 private:
  PlaneRange range_;
  SplitTests tests_;
  Split split_;
};

Split PlaneSurroundings::cheapest() {
  Best best(job_, cell_, plane_.axis);
  best.try_plane(plane_.position, left_, right_);
  if (los_.are_all() && his_.are_all()) {
    try_few_sides(best);
  } else {
    try_nearest_sides(best);
  }
  return best.split();
}

void PlaneSurroundings::try_few_sides(Best& best) {
  los_.sort();
  his_.sort();
  const auto los = los_.kept(), his = his_.kept();
  const auto try_plane = [&](float position) {
    if (position < first_ || position > last_) return;  // what lies there was not counted
    const auto begun = std::ranges::upper_bound(los, position) - los.begin();
    const auto to_end = his.end() - std::ranges::lower_bound(his, position);
    best.try_plane(position, before_ + static_cast<std::uint32_t>(begun),
                   behind_ + static_cast<std::uint32_t>(to_end));
  };
  for (const float lo : los) try_plane(next_down(lo));
  for (const float hi : his) try_plane(next_up(hi));
}

void PlaneSurroundings::try_nearest_sides(Best& best) const {
  const float below = next_up(below_), above = next_down(above_);
  if (below < plane_.position) best.try_plane(below, left_ - starts_, right_);
  if (above > plane_.position) best.try_plane(above, left_, right_ - ends_);
}

}  // namespace bspview
