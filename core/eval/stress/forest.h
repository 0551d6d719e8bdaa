#pragma once

#include <array>
#include <memory>

#include "core/eval/reference.h"
#include "core/eval/stress/brute.h"
#include "core/eval/stress/check.h"
#include "core/render/accelerator.h"

namespace bspview::stress {

/// A scene with its tree by every builder, and the right answers.
struct Forest {
  explicit Forest(std::shared_ptr<const Scene> grown)
      : scene(std::move(grown)), brute(*scene), reference(*scene) {}

  std::shared_ptr<const Scene> scene;
  BruteForce brute;     ///< with the tests of all pictures
  Reference reference;  ///< beyond rounding
  std::vector<Tree> trees;
  std::vector<std::shared_ptr<const Accelerator>> accelerators;  ///< of the trees

  /// A tree as it is, and as pictures go through it.
  std::array<World, 2> worlds(const Tree& tree) const {
    const auto index = static_cast<std::size_t>(&tree - trees.data());
    return {World{*scene, tree}, World{*scene, tree, accelerators[index].get()}};
  }
};

/// A tree by every builder and leaf size; by the naive one only where the scene is small.
Result<SharedForest> grow_forest(std::shared_ptr<const Scene> scene,
                                 std::span<const int> leaf_sizes);
inline constexpr int every_leaf_size[] = {1, 4, 16};

/// One forest a scene, with trees of every leaf size.
using Forests = std::shared_ptr<const std::vector<SharedForest>>;
Result<Forests> grow_forests(std::span<const std::shared_ptr<const Scene>> scenes);
Result<Forests> forests_of_scene(const Setting& setting);  ///< of the scene the user named

const Forest& choose_forest(const Forests& forests, Dice& dice);
const Tree& choose_tree(const Forest& forest, Dice& dice);

/// Builder and leaf size of a tree, and the scene, for complaints.
std::string describe(const World& world);

/// The ray's bits, to shoot it again.
std::string describe(const Ray& ray);
std::string describe(const Hit& hit);

/// Every tree of the forest, or every one of that leaf size but the naive one, must find what brute
/// force finds: the same object at the same distance.
Complaint compare_with_brute_force(const Subject& subject, const Forest& forest, const Ray& ray,
                                   std::optional<int> leaf_size = std::nullopt);

/// What the last tree finds must be right by exact arithmetic, its distance within an ulp of float.
Complaint compare_with_reference(const Subject& subject, const Forest& forest, const Ray& ray);

/// For compare_with_brute_force: one of the leaf sizes, now and then every tree.
std::optional<int> choose_leaf_size(Dice& dice);

/// A ray that starts in or around `box` and is aimed at `target`.  Some have an interval of their
/// own, which may reach behind the origin.
Ray ray_towards(Vec3 target, const Aabb& box, Dice& dice);

}  // namespace bspview::stress
