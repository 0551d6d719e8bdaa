#include "core/bsp/object_groups.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/math/largest_coordinate.h"

namespace bspview {
namespace {

/// An integer that is as great among its like as the number among all numbers.
std::uint64_t ordered(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  return bits >> 31 != 0 ? ~bits : bits | 0x80000000u;
}

}  // namespace

float area_unit(const Aabb& whole) {
  return std::ldexp(1.0f, -std::ilogb(std::clamp(largest_coordinate(whole), 0x1p-120f, 0x1p120f)));
}

ObjectGroups::Sides::Sides() {
  std::ranges::fill(below, -std::numeric_limits<float>::infinity());
  std::ranges::fill(above, -std::numeric_limits<float>::infinity());
}

ObjectGroups::Sides::Sides(const Aabb& box, float scale) : Sides() {
  for (int axis = 0; axis < 3; ++axis) {
    below[axis] = -scale * box.lo[axis];
    above[axis] = scale * box.hi[axis];
  }
}

void ObjectGroups::Sides::grow(const Sides& other) {
  for (int i = 0; i < 4; ++i) below[i] = std::max(below[i], other.below[i]);
  for (int i = 0; i < 4; ++i) above[i] = std::max(above[i], other.above[i]);
}

float ObjectGroups::Sides::half_area() const {
  const float x = below[0] + above[0], y = below[1] + above[1], z = below[2] + above[2];
  return x * y + y * z + z * x;
}

void ObjectGroups::add(std::uint32_t id, const Aabb& box, bool is_eighth) {
  objects_[size_++] = {Sides(box, unit_), box, id, is_eighth};
}

ObjectGroups::Range ObjectGroups::sort() {
  constexpr int index_bits = std::bit_width(most_objects) - 1;
  static_assert(most_objects == std::size_t{1} << index_bits);
  std::array<std::uint64_t, most_objects> keys;
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < size_; ++i) {
      const Sides& sides = objects_[i].sides;
      keys[i] = ordered(sides.above[axis] - sides.below[axis]) << index_bits | i;
    }
    std::sort(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(size_));
    for (std::size_t i = 0; i < size_; ++i) {
      order_[axis][i] = static_cast<std::uint16_t>(keys[i] % most_objects);
    }
  }
  return {0, size_};
}

std::optional<std::size_t> ObjectGroups::split(Range group) {
  if (group.size() < 2) return {};
  Split best = worst_split(group);
  for (int axis = 0; axis < 3; ++axis) find_best(axis, group, best);
  if (best.axis < 0) return {};
  for (std::size_t i = group.first; i < group.last; ++i) {
    is_second_[order_[best.axis][i]] = i >= best.place;
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != best.axis) partition(axis, group);
  }
  return best.place;
}

Aabb ObjectGroups::box(Range group) const {
  Aabb box;
  for (std::size_t i = group.first; i < group.last; ++i) box.grow(object(0, i).box);
  return box;
}

/// Of the cost that another must be below: what the group costs as it is.
ObjectGroups::Split ObjectGroups::worst_split(Range group) const {
  Sides sides;
  ObjectTests tests;
  for (std::size_t i = group.first; i < group.last; ++i) {
    sides.grow(object(0, i).sides);
    tests.add(object(0, i).is_eighth);
  }
  return {sides.half_area() * (tests.cost() - box_cost)};
}

void ObjectGroups::find_best(int axis, Range group, Split& best) {
  Sides sides;
  ObjectTests tests;
  for (std::size_t i = group.first; i + 1 < group.last; ++i) {
    const Object& next = object(axis, i);
    sides.grow(next.sides);
    tests.add(next.is_eighth);
    cost_before_[i + 1] = sides.half_area() * tests.cost();
  }
  sides = {};
  tests = {};
  for (std::size_t i = group.last - 1; i > group.first; --i) {
    const Object& next = object(axis, i);
    sides.grow(next.sides);
    tests.add(next.is_eighth);
    const float cost = cost_before_[i] + sides.half_area() * tests.cost();
    if (cost < best.cost) best = {cost, axis, i};
  }
}

/// The objects of the first group before those of the second, in order.
void ObjectGroups::partition(int axis, Range group) {
  std::array<std::uint16_t, most_objects> second;
  std::size_t firsts = group.first, seconds = 0;
  for (std::size_t i = group.first; i < group.last; ++i) {
    const std::uint16_t object = order_[axis][i];
    order_[axis][firsts] = second[seconds] = object;
    firsts += is_second_[object] ? 0 : 1;
    seconds += is_second_[object] ? 1 : 0;
  }
  std::copy_n(second.begin(), seconds, order_[axis].begin() + static_cast<std::ptrdiff_t>(firsts));
}

}  // namespace bspview
