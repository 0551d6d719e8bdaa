// T18: what is no ray hits nothing, soon.

#include <fmt/format.h>

#include <limits>

#include "core/eval/stress/forest.h"
#include "core/eval/stress/mesh.h"
#include "core/eval/stress/rows.h"
#include "core/eval/stress/scenes.h"

namespace bspview::stress {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

float bad_number(Dice& dice) {
  switch (dice.below(3)) {
    case 0:
      return nan;
    case 1:
      return infinity;
    default:
      return -infinity;
  }
}

/// A good ray made useless in one place or in several.
Ray no_ray(Ray ray, Dice& dice) {
  switch (dice.below(6)) {
    case 0:
      ray.direction = Vec3(dice.sign() * 0.0f, dice.sign() * 0.0f, dice.sign() * 0.0f);
      break;
    case 1:
      ray.direction[dice.below(3)] = bad_number(dice);
      break;
    case 2:
      ray.origin[dice.below(3)] = bad_number(dice);
      break;
    case 3:
      for (int axis = 0; axis < 3; ++axis) ray.origin[axis] = bad_number(dice);
      for (int axis = 0; axis < 3; ++axis) ray.direction[axis] = bad_number(dice);
      break;
    case 4:
      ray.t_min = dice.between(0.1f, 2.0f);
      ray.t_max = ray.t_min - dice.between(0.05f, 4.0f);
      break;
    default:
      (dice.one_in(2) ? ray.t_min : ray.t_max) = nan;
      break;
  }
  return ray;
}

}  // namespace

Result<Trial> prepare_no_rays(const Setting& setting) {
  Dice maker(setting.seed);
  const auto scene = std::make_shared<Scene>(make_mixed_scene(200, Vec3(0.0f), maker));
  const auto forest = grow_forest(scene, every_leaf_size);
  if (!forest) return forest.error();
  return Trial([subject = setting.subject, forest = *forest](Dice& dice) -> Complaint {
    const Aabb& box = forest->brute.bounds();
    const Vec3 target = aim_at(*forest->scene, box, Aim::anywhere, dice);
    const Ray ray = no_ray(ray_towards(target, box, dice), dice);
    for (const Tree& tree : forest->trees) {
      for (const World& world : forest->worlds(tree)) {
        RayCost cost;
        const Hit found = subject.closest(world, ray, cost);
        const bool occluded = subject.occluded(world, ray);
        if (!found && !occluded && cost.inner + cost.leaves <= 1) continue;
        return fmt::format(
            "{}: {}: expected nothing and at most one node, found {}, {} nodes, occluded {}",
            describe(world), describe(ray), describe(found), cost.inner + cost.leaves, occluded);
      }
    }
    return std::nullopt;
  });
}

}  // namespace bspview::stress
