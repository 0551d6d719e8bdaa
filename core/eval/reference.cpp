#include "core/eval/reference.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bspview {
namespace {

constexpr double same_place = 0x1p-21;  // 4 ulp of float, relative
/// A hit of the right object this far off its place, relative, is no longer that hit.
constexpr double other_place = 0x1p-10;
constexpr std::uint32_t group_size = 4;
/// What boxes are widened by, relative to the largest coordinate. Doubles are off by 2^-50.
constexpr double widening = 0x1p-30;

bool passes(const Aabb& box, const Ray& ray) {
  double enter = ray.t_min, exit = ray.t_max;
  enter -= widening * std::abs(enter);
  exit += widening * std::abs(exit);
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.origin[axis], d = ray.direction[axis];
    const double lo = box.lo[axis], hi = box.hi[axis];
    const double margin = widening * (std::abs(lo) + std::abs(hi) + std::abs(o));
    const double below = lo - margin - o, above = hi + margin - o;
    if (d == 0.0) {
      if (below > 0.0 || above < 0.0) return false;
      continue;
    }
    const double a = below / d, b = above / d;
    enter = std::max(enter, std::min(a, b));
    exit = std::min(exit, std::max(a, b));
  }
  return enter - widening * std::abs(enter) <= exit + widening * std::abs(exit);
}

bool are_together(double t, double other) {
  return std::abs(t - other) <= same_place * std::max(std::abs(t), std::abs(other));
}

/// Whether something is surely hit at `candidates[index]`.
bool is_sure(const std::vector<Candidate>& candidates, std::size_t index) {
  const Candidate& one = candidates[index];
  if (one.hit.meeting == Meeting::interior) return true;
  if (one.hit.meeting != Meeting::border) return false;
  return std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& other) {
    return other.object != one.object && other.hit.meeting == Meeting::border &&
           are_together(one.hit.t, other.hit.t);
  });
}

double nearest_sure(const std::vector<Candidate>& candidates) {
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (is_sure(candidates, i)) return candidates[i].hit.t;
  return no_hit;
}

/// The meeting with `object` nearest to `t`; null when there is none near.
const Candidate* find_meeting(const std::vector<Candidate>& candidates, std::uint32_t object,
                              double t) {
  const Candidate* best = nullptr;
  for (const Candidate& one : candidates) {
    if (one.object != object) continue;
    const double off = std::abs(one.hit.t - t);
    if (!(off <= other_place * std::abs(one.hit.t))) continue;
    if (best == nullptr || off < std::abs(best->hit.t - t)) best = &one;
  }
  return best;
}

double ulp_of_float(double t) {
  return std::ldexp(1.0, std::max(std::ilogb(t), -126) - 23);
}

}  // namespace

Reference::Reference(const Scene& scene) : scene_(scene) {
  const std::vector<Aabb> bounds = object_bounds(scene);
  for (std::uint32_t id = 0; id < bounds.size(); ++id)
    if (!bounds[id].empty()) order_.push_back(id);
  if (!order_.empty()) divide(0, static_cast<std::uint32_t>(order_.size()), bounds);
}

void Reference::divide(std::uint32_t first, std::uint32_t count, const std::vector<Aabb>& bounds) {
  const std::size_t index = groups_.size();
  Group group{.first = first, .count = count};
  const auto begin = order_.begin() + first, end = begin + count;
  for (auto id = begin; id != end; ++id) group.bounds.grow(bounds[*id]);
  groups_.push_back(group);
  if (count <= group_size) return;

  const Vec3 size = group.bounds.hi - group.bounds.lo;
  const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const std::uint32_t half = count / 2;
  std::nth_element(begin, begin + half, end, [&](std::uint32_t a, std::uint32_t b) {
    return bounds[a].lo[axis] < bounds[b].lo[axis];
  });
  divide(first, half, bounds);
  groups_[index].first = static_cast<std::uint32_t>(groups_.size());
  groups_[index].count = 0;
  divide(first + half, count - half, bounds);
}

std::vector<Candidate> Reference::meetings(const Ray& ray, SideRule rule) const {
  std::vector<Candidate> candidates;
  std::vector<std::uint32_t> open;
  if (!groups_.empty()) open.push_back(0);
  while (!open.empty()) {
    const std::uint32_t index = open.back();
    open.pop_back();
    const Group& group = groups_[index];
    if (!passes(group.bounds, ray)) continue;
    if (group.count == 0) {
      open.push_back(group.first);
      open.push_back(index + 1);
      continue;
    }
    for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
      const std::uint32_t id = order_[i];
      const Sides sides = visible_sides(scene_, scene_.objects[id], rule);
      for (const ExactHit& hit : exact_hits(scene_, id, ray, sides))
        if (hit.meeting != Meeting::miss) candidates.push_back({id, hit});
    }
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.hit.t < b.hit.t || (a.hit.t == b.hit.t && a.object < b.object);
  });
  return candidates;
}

Judgement Reference::judge(const Ray& ray, std::uint32_t object, double t, SideRule rule) const {
  // What lies well behind the answer cannot make it wrong.
  Ray looked_at = ray;
  looked_at.t_max = std::min(ray.t_max, next_up(round_up(t + 2.0 * other_place * std::abs(t))));
  const std::vector<Candidate> candidates = meetings(looked_at, rule);
  const double sure = nearest_sure(candidates);
  if (object == no_index) {
    if (sure != no_hit) return {Verdict::lost};
    return {candidates.empty() ? Verdict::right : Verdict::undecided};
  }
  const Candidate* met = find_meeting(candidates, object, t);
  if (met == nullptr) return {Verdict::phantom};
  const double exact = met->hit.t;
  if (sure < exact && !are_together(sure, exact)) return {Verdict::lost};
  return {Verdict::right, std::abs(t - exact) / ulp_of_float(exact)};
}

Verdict Reference::judge_any(const Ray& ray, bool hit, SideRule rule) const {
  const std::vector<Candidate> candidates = meetings(ray, rule);
  const bool sure = nearest_sure(candidates) != no_hit;
  if (hit) return candidates.empty() ? Verdict::phantom : Verdict::right;
  if (sure) return Verdict::lost;
  return candidates.empty() ? Verdict::right : Verdict::undecided;
}

}  // namespace bspview
