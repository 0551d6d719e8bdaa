// T04: the edge function gives neighbours exactly opposite areas, so that no ray falls between
// them.

#include <fmt/format.h>

#include "core/eval/stress/rows.h"
#include "core/math/exact.h"

namespace bspview::stress {
namespace {

Complaint compare_neighbours(const Subject& subject, Vec2 p, Vec2 q) {
  const float one = subject.edge(p, q), other = subject.edge(q, p), none = subject.edge(p, p);
  if (one == -other && none == 0.0f) return std::nullopt;
  return fmt::format(
      "edge from ({:a}, {:a}) to ({:a}, {:a}): areas {:a} and {:a} are not opposite, or that of "
      "the first point with itself, {:a}, is not 0",
      p.x, p.y, q.x, q.y, one, other, none);
}

Complaint compare_sides(Dice& dice) {
  const float size = dice.power_of_ten(-3.0f, 6.0f);
  const Vec3 o = dice.point(size), d = dice.direction(), a = dice.point(size),
             b = dice.one_in(2) ? a + 1e-6f * dice.point(size) : dice.point(size);
  const int one = side_of_edge(o, d, a, b), other = side_of_edge(o, d, b, a);
  if (one == -other) return std::nullopt;
  return fmt::format("{} {} {}: sides {} and {} are not opposite", o.x, o.y, o.z, one, other);
}

}  // namespace

Result<Trial> prepare_shared_edges(const Setting& setting) {
  return Trial([subject = setting.subject](Dice& dice) -> Complaint {
    const float size = dice.power_of_ten(-6.0f, 6.0f);
    const RayQuery ray({dice.point(size), dice.direction()});
    const Vec3 a = dice.point(size),
               b = dice.one_in(2) ? a + 1e-5f * dice.point(size) : dice.point(size);
    if (auto complaint = compare_neighbours(subject, ray.project(a), ray.project(b))) {
      return complaint;
    }
    return compare_sides(dice);
  });
}

}  // namespace bspview::stress
