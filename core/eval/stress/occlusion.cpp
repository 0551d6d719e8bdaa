// T20: a ray is occluded exactly when it hits something.

#include <fmt/format.h>

#include <array>

#include "core/eval/stress/forest.h"
#include "core/eval/stress/mesh.h"
#include "core/eval/stress/rows.h"
#include "core/eval/stress/scenes.h"

namespace bspview::stress {
namespace {

Result<Forests> own_forests(std::uint64_t seed) {
  Dice maker(seed);
  const std::array<std::shared_ptr<const Scene>, 3> scenes{
      std::make_shared<Scene>(make_mixed_scene(400, Vec3(0.0f), maker)),
      std::make_shared<Scene>(make_icosphere(3, Vec3(1000.0f)).scene),
      std::make_shared<Scene>(make_cube(8, Vec3(0.1f, 0.2f, 0.3f)).scene)};
  return grow_forests(scenes);
}

}  // namespace

Result<Trial> prepare_occlusion(const Setting& setting) {
  const auto forests = setting.scene ? forests_of_scene(setting) : own_forests(setting.seed);
  if (!forests) return forests.error();
  return Trial([subject = setting.subject, forests = *forests](Dice& dice) -> Complaint {
    const Forest& forest = choose_forest(forests, dice);
    const Aabb& box = forest.brute.bounds();
    const auto aim = static_cast<Aim>(dice.below(aim_count));
    Ray ray = ray_towards(aim_at(*forest.scene, box, aim, dice), box, dice);
    if (dice.one_in(2)) ray.t_max = std::max(0.0f, ray.t_min) + dice.between(0.0f, 1.5f);
    for (const World& world : forest.worlds(choose_tree(forest, dice))) {
      RayCost cost;
      const Hit hit = subject.closest(world, ray, cost);
      const bool occluded = subject.occluded(world, ray);
      if (occluded == static_cast<bool>(hit)) continue;
      return fmt::format("{}: {}: closest hit {}, but {}", describe(world), describe(ray),
                         describe(hit), occluded ? "occluded" : "not occluded");
    }
    return std::nullopt;
  });
}

}  // namespace bspview::stress
