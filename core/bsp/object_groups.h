#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/math/aabb.h"

namespace bspview {

/// A power of two: areas of boxes within `whole` that are scaled by it do not overflow, and vanish
/// only where the whole is beyond their reach.
float area_unit(const Aabb& whole);

/// What a ray pays for testing some objects, in tests of eight at once.
class ObjectTests {
 public:
  /// Of an object that is tested by itself, as measured.
  static constexpr int lone_cost = 2;

  /// `is_eighth`: eight like it are tested at once.
  void add(bool is_eighth) { eighths_ += is_eighth ? 1 : 8 * lone_cost; }
  float cost() const { return static_cast<float>((eighths_ + 7) / 8); }

 private:
  std::uint32_t eighths_ = 0;
};

/// The objects of a small branch of a tree, to be dealt out to groups in boxes of their own: planes
/// would cut many of them before a ray meets most. Groups are split by the surface area heuristic
/// where objects sorted by their middles cost least on both sides (Wald, Boulos & Shirley 2007,
/// section 3); their boxes may overlap.
class ObjectGroups {
 public:
  /// Of one branch. The more there are, the fewer steps rays take, and the longer groups take to
  /// make; larger leaves are as their builder was asked to leave them.
  static constexpr std::size_t most_objects = 512;
  /// Of groups, one below the other.
  static constexpr int most_levels = 16;
  /// What a ray pays for a box, in tests of eight objects at once; as measured.
  static constexpr float box_cost = 1.2f;

  /// Some of the objects, by their places.
  struct Range {
    std::size_t first, last;
    std::size_t size() const { return last - first; }
  };

  /// `unit`: see area_unit, of the tree.
  explicit ObjectGroups(float unit) : unit_(unit) {}

  void clear() { size_ = 0; }
  std::size_t size() const { return size_; }
  /// What of an object lies in the branch; at most most_objects.
  void add(std::uint32_t id, const Aabb& box, bool is_eighth);
  /// Once all are there.
  Range sort();

  /// Deals a group out to two, the second from the place of the answer on; or nothing where one box
  /// is the best.
  std::optional<std::size_t> split(Range group);

  Aabb box(Range group) const;
  std::uint32_t id(std::size_t place) const { return objects_[order_[0][place]].id; }

 private:
  /// A box by -lo and hi: the greatest of both sides make the box around two.
  struct alignas(16) Sides {
    Sides();
    Sides(const Aabb& box, float scale);
    void grow(const Sides& other);
    float half_area() const;

    float below[4], above[4];
  };
  struct Object {
    Sides sides;  ///< times the unit
    Aabb box;
    std::uint32_t id;
    bool is_eighth;
  };
  struct Split {
    float cost;
    int axis = -1;
    std::size_t place = 0;
  };

  const Object& object(int axis, std::size_t place) const { return objects_[order_[axis][place]]; }
  Split worst_split(Range group) const;
  void find_best(int axis, Range group, Split& best);
  void partition(int axis, Range group);

  const float unit_;
  std::size_t size_ = 0;
  std::array<Object, most_objects> objects_;
  std::array<std::array<std::uint16_t, most_objects>, 3> order_;  // by axis: by their middle
  std::array<float, most_objects> cost_before_;  // by place: of the objects before it in the group
  std::array<bool, most_objects> is_second_;     // by object: in the group of two
};

}  // namespace bspview
