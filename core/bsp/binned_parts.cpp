#include "core/bsp/binned_parts.h"

#include "core/bsp/bin_planes.h"
#include "core/bsp/clip_part.h"

namespace bspview {

void BinnedParts::write_objects(std::uint32_t* to) const {
  for (const ObjectPart& part : parts()) *to++ = part.object;
}

std::optional<Split> BinnedParts::find_split(const Place& place) const {
  const Split best = cheapest_of_bins(*job_, parts(), place.cell);
  return std::isfinite(best.tests) ? std::optional(best) : std::nullopt;
}

FewParts BinnedParts::few_parts(ScratchStack& scratch) const {
  FewParts few(*job_, scratch);
  for (const ObjectPart& part : parts()) few.push(part.box, part.object);
  return few;
}

BinnedParts BinnedParts::split(const CellSplit& split, ScratchStack& scratch) {
  BinnedParts other(*job_, std::min(split.left, split.right), scratch);
  BinnedParts& left = split.keeps_left() ? *this : other;
  BinnedParts& right = split.keeps_left() ? other : *this;
  const std::size_t count = std::exchange(count_, 0);
  job_->for_each(count, clip_steps, [&](std::size_t i) {
    const auto [box, object] = parts_[i];  // before others take its place
    const bool goes_left = component(box.lo, split.axis) <= split.position;
    const bool goes_right = component(box.hi, split.axis) >= split.position;
    const bool clip = job_->clip && goes_left && goes_right;
    const SideBoxes boxes = clip ? clip_sides(*job_, object, split) : SideBoxes{box, box};
    if (goes_left && !boxes.left.empty()) left.push(boxes.left, object);
    if (goes_right && !boxes.right.empty()) right.push(boxes.right, object);
  });
  return other;
}

}  // namespace bspview
