#include "core/eval/stress/forest.h"

#include <fmt/format.h>

#include "core/base/parallel.h"
#include "core/render/scene_tree.h"

namespace bspview::stress {
namespace {

/// Testing every object of larger scenes takes the time of a thousand walks through a tree.
constexpr std::size_t largest_naive = 2000;

/// Of nodes and references. Splitting at middles makes trees of 640 MB of spd:shells; cut to this,
/// they are as hard to walk.
constexpr std::size_t largest_tree = std::size_t{1} << 28;

std::vector<BuildParams> tree_kinds(std::size_t objects, std::span<const int> leaf_sizes) {
  std::vector<BuildParams> kinds;
  const auto count = static_cast<int>(builder_names().size());
  for (int builder = 0; builder < count; ++builder) {
    const bool naive = static_cast<Builder>(builder) == Builder::naive;
    if (naive && objects > largest_naive) continue;
    for (const int leaf_size : naive ? leaf_sizes.first(1) : leaf_sizes) {
      kinds.push_back({.builder = static_cast<Builder>(builder),
                       .leaf_size = leaf_size,
                       .memory_limit = largest_tree,
                       .threads = 1});
    }
  }
  return kinds;
}

}  // namespace

Result<SharedForest> grow_forest(std::shared_ptr<const Scene> scene,
                                 std::span<const int> leaf_sizes) {
  const auto forest = std::make_shared<Forest>(std::move(scene));
  const std::vector<BuildParams> kinds = tree_kinds(forest->scene->objects.size(), leaf_sizes);
  forest->trees.resize(kinds.size());
  forest->accelerators.resize(kinds.size());
  std::vector<std::optional<Error>> errors(kinds.size());
  parallel_for(static_cast<int>(kinds.size()), [&](int kind) {
    const auto i = static_cast<std::size_t>(kind);
    auto tree = build_scene_tree(*forest->scene, kinds[i]);
    if (!tree) errors[i] = tree.error();
    if (!tree) return;
    forest->trees[i] = *std::move(tree);
    forest->accelerators[i] = make_accelerator({*forest->scene, forest->trees[i]});
  });
  for (const auto& error : errors)
    if (error) return *error;
  return SharedForest(forest);
}

Result<Forests> grow_forests(std::span<const std::shared_ptr<const Scene>> scenes) {
  std::vector<SharedForest> forests;
  for (const auto& scene : scenes) {
    auto forest = grow_forest(scene, every_leaf_size);
    if (!forest) return forest.error();
    forests.push_back(*std::move(forest));
  }
  return std::make_shared<const std::vector<SharedForest>>(std::move(forests));
}

Result<Forests> forests_of_scene(const Setting& setting) {
  auto forest = setting.forest();
  if (!forest) return forest.error();
  return std::make_shared<const std::vector<SharedForest>>(1, *std::move(forest));
}

const Forest& choose_forest(const Forests& forests, Dice& dice) {
  return *(*forests)[static_cast<std::size_t>(dice.below(static_cast<int>(forests->size())))];
}

const Tree& choose_tree(const Forest& forest, Dice& dice) {
  const auto count = static_cast<int>(forest.trees.size());
  return forest.trees[static_cast<std::size_t>(dice.below(count))];
}

std::string describe(const World& world) {
  return fmt::format("{} by {}, leaf size {}{}", world.scene.name,
                     name_of(world.tree.params.builder), world.tree.params.leaf_size,
                     world.accelerator != nullptr ? ", wide nodes" : "");
}

std::string describe(const Ray& ray) {
  return fmt::format("ray {:a} {:a} {:a}  {:a} {:a} {:a}  {:a} {:a}", ray.origin.x, ray.origin.y,
                     ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z, ray.t_min,
                     ray.t_max);
}

std::string describe(const Hit& hit) {
  return hit ? fmt::format("object {} at {:a}", hit.object, hit.t) : "nothing";
}

Complaint compare_with_brute_force(const Subject& subject, const Forest& forest, const Ray& ray,
                                   std::optional<int> leaf_size) {
  const Hit expected = forest.brute.closest(ray);
  for (const Tree& tree : forest.trees) {
    if (leaf_size && (tree.naive || tree.params.leaf_size != *leaf_size)) continue;
    for (const World& world : forest.worlds(tree)) {
      RayCost cost;
      const Hit found = subject.closest(world, ray, cost);
      if (found.object == expected.object && found.t == expected.t) continue;
      return fmt::format("{}: {}: expected {}, found {}", describe(world), describe(ray),
                         describe(expected), describe(found));
    }
  }
  return std::nullopt;
}

Complaint compare_with_reference(const Subject& subject, const Forest& forest, const Ray& ray) {
  const World world = forest.worlds(forest.trees.back())[1];
  RayCost cost;
  const Hit found = subject.closest(world, ray, cost);
  const Judgement judged = forest.reference.judge(ray, found.object, found.t);
  const bool wrong = judged.verdict == Verdict::lost || judged.verdict == Verdict::phantom;
  if (!wrong && judged.t_error <= 1.0) return std::nullopt;
  return fmt::format("{}: {}: found {}, which exact arithmetic calls {} ({:.2f} ulp)",
                     describe(world), describe(ray), describe(found),
                     judged.verdict == Verdict::lost      ? "lost"
                     : judged.verdict == Verdict::phantom ? "a phantom"
                                                          : "inexact",
                     judged.t_error);
}

std::optional<int> choose_leaf_size(Dice& dice) {
  if (dice.one_in(16)) return std::nullopt;
  return every_leaf_size[dice.below(3)];
}

Ray ray_towards(Vec3 target, const Aabb& box, Dice& dice) {
  const Vec3 place = dice.point(dice.one_in(2) ? 0.5f : 1.5f);
  const Vec3 origin = box.centre() + place * box.extent();
  const Vec3 direction = target - origin;
  Ray ray{origin, direction == Vec3(0.0f) ? dice.direction() : direction};
  if (dice.one_in(8)) ray.t_min = dice.between(-3.0f, 1.0f);
  if (dice.one_in(8)) ray.t_max = ray.t_min + dice.between(0.0f, 3.0f);
  return ray;
}

}  // namespace bspview::stress
