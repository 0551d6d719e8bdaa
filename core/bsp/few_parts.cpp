#include "core/bsp/few_parts.h"

#include "core/bsp/clip_part.h"

namespace bspview {

void FewParts::append_objects(References& objects) const {
  objects.insert(objects.end(), objects_.data(), objects_.data() + count_);
}

double FewParts::tests() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < count_; ++i) sum += boxes_[i].tests();
  return sum;
}

std::optional<Split> FewParts::find_split(const Place& place) const {
  Split split = cheapest_of_few(*job_, std::span(boxes_).first(count_), place.cell);
  if (!std::isfinite(split.cost)) return {};
  for (std::size_t i = 0; i < count_; ++i) {
    split.left += boxes_[i].lo[split.axis] <= split.position;
    split.right += boxes_[i].hi[split.axis] >= split.position;
  }
  return split;
}

/// Adds the two sides of a part; `outlines` has room for theirs.
void FewParts::cut(const Part& part, const CellSplit& split, Outline* outlines,
                   const Sides& to) const {
  const auto add = [&](FewParts& side, const Aabb& box, const Outline* outline) {
    if (!box.empty()) side.keep({few_box(box, part.box.tests()), part.object, outline});
  };
  Outline whole;
  const bool has_outline = part.outline || find_outline(*job_, part.object, split.cell, whole);
  if (has_outline &&
      divide(*job_, part.outline ? *part.outline : whole, split, {outlines[0], outlines[1]})) {
    add(to.left, box_of_part(*job_, outlines[0], part.object, split.cells.left), &outlines[0]);
    add(to.right, box_of_part(*job_, outlines[1], part.object, split.cells.right), &outlines[1]);
    return;
  }
  add(to.left, clipped_box(*job_, part.object, split.cells.left), nullptr);
  add(to.right, clipped_box(*job_, part.object, split.cells.right), nullptr);
}

FewParts FewParts::split(const CellSplit& split, ScratchStack& scratch) {
  const std::size_t straddling = split.left + split.right - count_;
  FewParts other(*job_, job_->clip ? 2 * straddling : 0, scratch);
  FewParts& left = split.keeps_left() ? *this : other;
  FewParts& right = split.keeps_left() ? other : *this;
  Outline* outlines = other.outlines_.data();
  const std::size_t count = std::exchange(count_, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const Part here = part(i);
    const bool goes_left = here.box.lo[split.axis] <= split.position;
    const bool goes_right = here.box.hi[split.axis] >= split.position;
    if (job_->clip && goes_left && goes_right) {
      cut(here, split, outlines, {left, right});
      outlines += 2;
      continue;
    }
    if (goes_left) left.keep(here);
    if (goes_right) right.keep(here);
  }
  return other;
}

}  // namespace bspview
