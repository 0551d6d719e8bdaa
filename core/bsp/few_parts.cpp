#include "core/bsp/few_parts.h"

#include <cmath>
#include <utility>

#include "core/bsp/clip_part.h"

namespace bspview {
namespace {

/// Larger outlines, and those that grow by more than this when they are cut, as concave polygons
/// may over and over, are not kept, lest they take much memory: they are found anew.
constexpr std::size_t most_corners_kept = 256;
constexpr std::size_t most_growth = 8;

}  // namespace

void FewParts::write_objects(std::uint32_t* to) const {
  for (std::size_t i = 0; i < count_; ++i) to[i] = objects_[i];
}

double FewParts::tests() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < count_; ++i) sum += boxes_[i].tests();
  return sum;
}

std::optional<Split> FewParts::find_split(const Place& place) const {
  const Split split = cheapest_of_few(*job_, std::span(boxes_).first(count_), place.cell);
  if (!std::isfinite(split.tests)) return {};
  std::uint32_t left = 0, right = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    left += boxes_[i].lo[split.axis] <= split.position;
    right += boxes_[i].hi[split.axis] >= split.position;
  }
  return Split{split.axis, split.position, left, right, split.tests};
}

/// Adds the two sides of a part; its outlines go on the pile of this.
void FewParts::cut(const Part& part, const CellSplit& split, const Sides& to) {
  if (!part.outline.empty()) return divide_outline(part, split, part.outline, to);
  OutlineRooms rooms;
  if (const auto whole = find_outline(*job_, part.object, split.cell, rooms)) {
    return divide_outline(part, split, *whole, to);
  }
  const auto add = [&](FewParts& side, const Aabb& cell) {
    const Aabb box = clipped_box(*job_, part.object, cell);
    if (!box.empty()) side.keep({few_box(box, part.box.tests()), part.object, {}});
  };
  add(to.left, split.cells.left);
  add(to.right, split.cells.right);
}

void FewParts::divide_outline(const Part& part, const CellSplit& split, Outline whole,
                              const Sides& to) {
  const std::size_t corners = 2 * outline_room(whole.size());
  const bool is_large = whole.size() > most_corners_kept;
  OutlineRoom large;
  OutlineCorner* const room = is_large ? large.of(corners) : outlines_.take<OutlineCorner>(corners);
  const OutlineSides sides =
      divide(whole, part.box, {split.axis, split.position, job_->clip_margin}, room,
             {to.left.boxes_[to.left.count_], to.right.boxes_[to.right.count_]});
  const std::size_t most_kept = is_large ? 0 : whole.size() + most_growth;
  const auto add = [&](FewParts& parts, Outline side) {
    const std::size_t kept = side.size() <= most_kept ? side.size() : 0;
    parts.objects_[parts.count_] = part.object;
    parts.corners_[parts.count_] = {side.data(), kept};
    parts.count_ += !side.empty();
  };
  add(to.left, sides.left);
  add(to.right, sides.right);
}

FewParts FewParts::split(const CellSplit& split, ScratchStack& scratch) {
  FewParts other(*job_, scratch);
  FewParts& left = split.keeps_left() ? *this : other;
  FewParts& right = split.keeps_left() ? other : *this;
  const std::size_t count = std::exchange(count_, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const Part here = part(i);
    const bool goes_left = here.box.lo[split.axis] <= split.position;
    const bool goes_right = here.box.hi[split.axis] >= split.position;
    if (job_->clip && goes_left && goes_right) {
      other.cut(here, split, {left, right});
    } else {
      left.keep_if(goes_left, here);
      right.keep_if(goes_right, here);
    }
  }
  return other;
}

}  // namespace bspview
