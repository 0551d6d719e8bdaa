#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>

namespace bspview {

/// Where a plane that sweeps along an axis meets or leaves the part of an object, in 8 bytes that
/// sort as one integer: by position, ends before starts, then by part.
///
///     63 .. 32   position, an integer that sorts like the float
///     31         0: end, 1: start
///     30 .. 0    index of the part in its node
///
/// Leaves are closed: a part that touches a plane lies on both sides of it. The events therefore
/// lie one float outside the part, and between them, both excluded, the plane touches it. So a
/// plane that is put at an event leaves that part on one side, and the same order serves planar
/// parts, which are two floats thick.
class Event {
 public:
  static Event make_start(float lo, std::uint32_t part) { return {before(rank(lo)), 1, part}; }
  static Event make_end(float hi, std::uint32_t part) { return {after(rank(hi)), 0, part}; }

  bool is_start() const { return bits_ >> 31 & 1; }
  bool is_end() const { return !is_start(); }
  std::uint32_t part() const { return static_cast<std::uint32_t>(bits_) & part_mask; }
  float position() const { return at_rank(static_cast<std::uint32_t>(bits_ >> 32)); }
  /// Where the part itself begins or ends.
  float bound() const {
    const auto rank = static_cast<std::uint32_t>(bits_ >> 32);
    return at_rank(is_start() ? after(rank) : before(rank));
  }
  Event with_part(std::uint32_t part) const {
    return Event((bits_ & ~std::uint64_t{part_mask}) | (part & part_mask));
  }
  std::uint64_t bits() const { return bits_; }

  auto operator<=>(const Event&) const = default;

  static constexpr std::uint32_t part_mask = 0x7fffffffu;

 private:
  static constexpr std::uint32_t sign = 0x80000000u;
  static constexpr std::uint32_t minus_zero = 0x7fffffffu;

  explicit Event(std::uint64_t bits) : bits_(bits) {}
  Event(std::uint32_t rank, std::uint32_t start, std::uint32_t part)
      : bits_(std::uint64_t{rank} << 32 | start << 31 | part) {}

  // Orders floats as integers; both zeros have the rank of +0.
  static std::uint32_t rank(float x) {
    const auto bits = std::bit_cast<std::uint32_t>(x + 0.0f);
    return bits & sign ? ~bits : bits | sign;
  }
  static float at_rank(std::uint32_t rank) {
    return std::bit_cast<float>(rank & sign ? rank ^ sign : ~rank);
  }
  static std::uint32_t before(std::uint32_t rank) {
    return rank - (rank - 1 == minus_zero ? 2 : 1);
  }
  static std::uint32_t after(std::uint32_t rank) { return rank + (rank + 1 == minus_zero ? 2 : 1); }

  std::uint64_t bits_;
};

/// How many of the sorted `events` lie before `position`; then: not behind it.
inline std::size_t count_before(std::span<const Event> events, float position) {
  const auto before = [&](Event event) { return event.position() < position; };
  return std::ranges::partition_point(events, before) - events.begin();
}
inline std::size_t count_up_to(std::span<const Event> events, float position) {
  const auto not_behind = [&](Event event) { return event.position() <= position; };
  return std::ranges::partition_point(events, not_behind) - events.begin();
}

}  // namespace bspview
