#include "core/bsp/box_list.h"

#include <algorithm>

#include "core/bsp/clip_part.h"
#include "core/math/float_error.h"

namespace bspview {

void BoxList::write_objects(std::uint32_t* to) const {
  for (const ObjectPart& part : parts_) *to++ = part.object;
}

BoxList BoxList::split(const CellSplit& split, ScratchStack&) {
  ObjectParts left, right;
  left.reserve(split.left);
  right.reserve(split.right);
  const auto deal = [](ObjectParts& side, const Aabb& box, std::uint32_t object) {
    if (!box.empty()) side.push_back({box, object});
  };
  job_->for_each(parts_.size(), clip_steps, [&](std::size_t i) {
    const auto& [box, object] = parts_[i];
    const bool goes_left = box.lo[split.axis] <= split.position;
    const bool goes_right = box.hi[split.axis] >= split.position;
    const bool clip = job_->clip && goes_left && goes_right;
    const SideBoxes boxes = clip ? clip_sides(*job_, object, split) : SideBoxes{box, box};
    if (goes_left) deal(left, boxes.left, object);
    if (goes_right) deal(right, boxes.right, object);
  });
  if (!split.keeps_left()) std::swap(left, right);
  parts_ = std::move(left);
  return BoxList(*job_, rule_, std::move(right));
}

Split count_sides(const BuildJob& job, std::span<const ObjectPart> parts, int axis,
                  float position) {
  Split split{.axis = axis, .position = position};
  job.for_each(parts.size(), light_steps, [&](std::size_t i) {
    split.left += parts[i].box.lo[axis] <= position;
    split.right += parts[i].box.hi[axis] >= position;
  });
  return split;
}

bool divides(const Split& split, std::size_t count) {
  return split.left < count || split.right < count;
}

float object_median(std::span<const ObjectPart> parts, int axis) {
  constexpr std::size_t most_parts = std::size_t{1} << 15;
  const std::size_t stride = (parts.size() + most_parts - 1) / most_parts;
  std::vector<float> edges;
  edges.reserve(2 * std::min(parts.size(), most_parts));
  for (std::size_t i = 0; i < parts.size(); i += stride) {
    edges.push_back(next_down(parts[i].box.lo[axis]));
    edges.push_back(next_up(parts[i].box.hi[axis]));
  }
  const auto middle = edges.begin() + edges.size() / 2;
  std::ranges::nth_element(edges, middle);
  return *middle;
}

std::array<int, 3> axes_by_length(const Aabb& cell) {
  std::array<int, 3> axes{0, 1, 2};
  std::ranges::stable_sort(axes, [&](int a, int b) {
    return double{cell.hi[a]} - cell.lo[a] > double{cell.hi[b]} - cell.lo[b];
  });
  return axes;
}

}  // namespace bspview
