#pragma once

#include <vector>

#include "core/eval/exact_hit.h"

namespace bspview {

/// One place where a ray surely or perhaps meets an object.
struct Candidate {
  std::uint32_t object = no_index;
  ExactHit hit;
};

/// What is wrong with an answer.
enum class Verdict {
  right,
  lost,      ///< something nearer is surely hit, or the answer is a miss where something is
  phantom,   ///< the object is not hit, or not there
  undecided  ///< either answer can be defended: a border of one object alone, a tangent
};

struct Judgement {
  Verdict verdict = Verdict::right;
  double t_error = 0.0;  ///< of a right hit: |t - exact t| in ulp of float of the exact t
};

/// Right answers for one scene, by brute force over all objects whose boxes, widened far beyond
/// any rounding, a ray meets. The scene outlives it.
class Reference {
 public:
  explicit Reference(const Scene& scene);

  /// Everything that the ray meets in its interval, nearest first, ties by id.
  std::vector<Candidate> meetings(const Ray& ray, SideRule rule = SideRule::two_sided) const;

  /// Judges a closest hit: `object` (no_index: a miss) at distance `t`. Surfaces within 4 ulp of
  /// float of each other count as equally near; a border counts as surely hit where two objects
  /// share it, since one of them must catch the ray.
  Judgement judge(const Ray& ray, std::uint32_t object, double t,
                  SideRule rule = SideRule::two_sided) const;
  /// Judges whether something is hit at all.
  Verdict judge_any(const Ray& ray, bool hit, SideRule rule = SideRule::two_sided) const;

 private:
  struct Group {  // of objects that lie together
    Aabb bounds;
    std::uint32_t first = 0;  // leaf: index into order_; inner: of the second child's group
    std::uint32_t count = 0;  // of objects; 0: inner, the first child follows
  };
  void divide(std::uint32_t first, std::uint32_t count, const std::vector<Aabb>& bounds);

  const Scene& scene_;
  std::vector<Group> groups_;
  std::vector<std::uint32_t> order_;  // ids of objects
};

}  // namespace bspview
