// T17: objects made of random bits do no harm to others. T18: what is no ray hits nothing, soon.

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

/// Any float, but mostly one of a size that is traced.
float wild_number(Dice& dice) {
  if (dice.one_in(3)) return dice.any_float();
  return dice.sign() * dice.power_of_ten(-20.0f, 20.0f);
}

Vec3 wild_point(Dice& dice) {
  const float x = dice.one_in(2) ? dice.between(-1.0f, 1.0f) : wild_number(dice);
  const float y = dice.one_in(2) ? dice.between(-1.0f, 1.0f) : wild_number(dice);
  return {x, y, dice.one_in(2) ? dice.between(-1.0f, 1.0f) : wild_number(dice)};
}

void add_wild(Scene& scene, Dice& dice) {
  switch (dice.below(3)) {
    case 0: {
      std::vector<Vec3> vertices(static_cast<std::size_t>(3 + dice.below(3)));
      for (Vec3& vertex : vertices) vertex = wild_point(dice);
      return add_face(scene, 0, vertices);
    }
    case 1:
      return add_sphere(scene, 0, {wild_point(dice), wild_number(dice)});
    default:
      return add_cone(scene, 0,
                      {wild_point(dice), wild_number(dice), wild_point(dice), wild_number(dice)});
  }
}

/// Small spheres, of which each has a wild neighbour behind it in the list.
Scene wild_scene(Dice& dice) {
  Scene scene;
  scene.name = "wild scene";
  scene.materials.resize(1);
  for (int i = 0; i < 20; ++i) {
    add_sphere(scene, 0, {dice.point(1.0f), dice.between(0.05f, 0.2f)});
    add_wild(scene, dice);
  }
  return scene;
}

/// The valid sphere must be hit, or something in front of it.
Complaint shoot_at_valid(const Subject& subject, const Forest& forest, Dice& dice) {
  const Sphere& sphere =
      forest.scene
          ->spheres[forest.scene->objects[static_cast<std::size_t>(2 * dice.below(20))].shape];
  const Vec3 origin = dice.point(3.0f);
  const Ray ray{origin, sphere.centre - origin};
  for (const Tree& tree : forest.trees) {
    RayCost cost;
    const Hit found = subject.closest({*forest.scene, tree}, ray, cost);
    if (found && found.t <= 1.0 + 1e-6) continue;
    return fmt::format("{}: {}: expected a sphere's front, found {}", describe(forest, tree),
                       describe(ray), describe(found));
  }
  return std::nullopt;
}

/// Whatever the ray and the objects, an answer is an object at a distance inside the interval. (A
/// cone of length 1e9 and radius 1e-9 is beyond double: which wild object is hit is left open.)
Complaint shoot_anywhere(const Subject& subject, const Forest& forest, Dice& dice) {
  const Ray ray{wild_point(dice), wild_point(dice), wild_number(dice), wild_number(dice)};
  for (const Tree& tree : forest.trees) {
    RayCost cost;
    const Hit found = subject.closest({*forest.scene, tree}, ray, cost);
    const bool inside = ray.t_min < found.t && found.t < ray.t_max;
    if (!found || (inside && found.object < forest.scene->objects.size())) continue;
    return fmt::format("{}: {}: expected a hit inside the interval, found {}",
                       describe(forest, tree), describe(ray), describe(found));
  }
  return std::nullopt;
}

}  // namespace

Result<Trial> prepare_wild_scenes(const Setting& setting) {
  return Trial([subject = setting.subject](Dice& dice) -> Complaint {
    const auto forest =
        grow_forest(std::make_shared<Scene>(wild_scene(dice)), std::span(every_leaf_size).first(1));
    if (!forest) return forest.error().message;
    for (int i = 0; i < 20; ++i) {
      if (auto complaint = shoot_at_valid(subject, **forest, dice)) return complaint;
      if (auto complaint = shoot_anywhere(subject, **forest, dice)) return complaint;
    }
    return std::nullopt;
  });
}

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
      RayCost cost;
      const Hit found = subject.closest({*forest->scene, tree}, ray, cost);
      const bool occluded = subject.occluded({*forest->scene, tree}, ray);
      if (!found && !occluded && cost.inner + cost.leaves <= 1) continue;
      return fmt::format(
          "{}: {}: expected nothing and at most one node, found {}, {} nodes, occluded {}",
          describe(*forest, tree), describe(ray), describe(found), cost.inner + cost.leaves,
          occluded);
    }
    return std::nullopt;
  });
}

}  // namespace bspview::stress
