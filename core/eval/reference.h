#pragma once

#include <span>
#include <vector>

#include "core/eval/exact_hit.h"

namespace bspview {

/// One object that a ray surely or perhaps meets.
struct Candidate {
  std::uint32_t object = no_index;
  ExactHit hit;
};

/// What is wrong with an answer.
enum class Verdict {
  right,
  lost,      ///< something nearer is surely hit, or the answer is a miss where something is
  phantom,   ///< the object is not hit, or not there
  undecided  ///< both answers can be defended: a border of one object alone, a tangent
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

  /// All objects that the ray meets in its interval, nearest first, ties by id.
  std::vector<Candidate> meetings(const Ray& ray, SideRule rule = SideRule::two_sided) const;

  /// Judges a closest hit: `object` (no_index: a miss) at distance `t`. Surfaces within 4 ulp of
  /// float of each other count as equally near; a border counts as surely hit where two objects
  /// share it, since one of them must catch the ray.
  Judgement judge(const Ray& ray, std::uint32_t object, double t,
                  SideRule rule = SideRule::two_sided) const;
  /// Judges "something is hit": lost or phantom.
  Verdict judge_any(const Ray& ray, bool hit, SideRule rule = SideRule::two_sided) const;

 private:
  struct Box {
    Aabb bounds;
    std::uint32_t first, count;  // inner: count == 0, children follow at index + 1 and `first`
  };

  const Scene& scene_;
  std::vector<Box> boxes_;
  std::vector<std::uint32_t> objects_;  // in the order of the leaves of boxes_
};

}  // namespace bspview
