// T09: objects that all lie in one plane, and a root without thickness.

#include <array>

#include "core/eval/stress/forest.h"
#include "core/eval/stress/mesh.h"
#include "core/eval/stress/rows.h"
#include "core/eval/stress/scenes.h"

namespace bspview::stress {
namespace {

/// Half of the rays cross the plane, the others lie in it or almost.
Ray coplanar_ray(const Forest& forest, Dice& dice) {
  const Aabb& box = forest.brute.bounds();
  const Vec3 target = aim_at(*forest.scene, box, static_cast<Aim>(dice.below(aim_count)), dice);
  if (dice.one_in(2)) return {target + dice.point(2.0f), dice.direction()};
  const Vec3 origin =
      dice.one_in(3) ? aim_at(*forest.scene, box, Aim::vertex, dice) : target + dice.point(2.0f);
  Ray ray{origin, target - origin};
  const int axis = dice.below(3);
  if (dice.one_in(2)) ray.origin[axis] = box.lo[axis];
  if (dice.one_in(3)) ray.direction[dice.below(3)] = dice.sign() * 0.0f;
  if (ray.direction == Vec3(0.0f)) ray.direction = dice.direction();
  return ray;
}

}  // namespace

Result<Trial> prepare_coplanar_objects(const Setting& setting) {
  Dice maker(setting.seed);
  std::vector<std::shared_ptr<const Scene>> scenes;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float position : {0.0f, 0.1f, -1000.0f}) {
      for (const int count : {1, 200}) {
        scenes.push_back(
            std::make_shared<Scene>(make_coplanar_scene(count, axis, position, maker)));
      }
    }
  }
  const auto forests = grow_forests(scenes);
  if (!forests) return forests.error();
  return Trial([subject = setting.subject, forests = *forests](Dice& dice) {
    const Forest& forest = choose_forest(forests, dice);
    const Ray ray = coplanar_ray(forest, dice);
    return compare_with_brute_force(subject, forest, ray, choose_leaf_size(dice));
  });
}

}  // namespace bspview::stress
