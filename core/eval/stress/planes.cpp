// T08: rays that start in split planes, vertices and faces of boxes and run along the axes and
// diagonals, with zeros of both signs and components that are almost 0.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/eval/stress/forest.h"
#include "core/eval/stress/mesh.h"
#include "core/eval/stress/rows.h"
#include "core/eval/stress/scenes.h"

namespace bspview::stress {
namespace {

std::uint64_t visited(const RayCost& cost) {
  return cost.inner + cost.leaves;
}

std::uint64_t median(std::vector<std::uint64_t>& counts) {
  const auto middle = counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2);
  std::ranges::nth_element(counts, middle);
  return *middle;
}

/// Moves `point` onto up to three split planes of the tree.
Vec3 onto_planes(const Tree& tree, Vec3 point, Dice& dice) {
  const auto nodes = static_cast<int>(tree.nodes.size());
  for (int wish = dice.below(6); wish >= 0; --wish) {
    const Node& node = tree.nodes[static_cast<std::size_t>(dice.below(nodes))];
    if (!node.is_leaf()) point[node.axis()] = node.split();
  }
  return point;
}

Vec3 onto_face(const Aabb& box, Vec3 point, Dice& dice) {
  const int axis = dice.below(3);
  point[axis] = dice.one_in(2) ? box.lo[axis] : box.hi[axis];
  return point;
}

Vec3 special_origin(const Forest& forest, Dice& dice) {
  const Tree& tree = choose_tree(forest, dice);
  const Scene& scene = *forest.scene;
  const Aabb& box = forest.brute.bounds();
  const Vec3 anywhere = aim_at(scene, box, Aim::anywhere, dice);
  switch (dice.below(5)) {
    case 0:
    case 1:
      return onto_planes(tree, anywhere, dice);
    case 2:
      return aim_at(scene, box, Aim::vertex, dice);
    case 3:
      return onto_face(dice.one_in(2) ? tree.box : box, anywhere, dice);
    default: {
      const auto objects = static_cast<int>(scene.objects.size());
      const Aabb own = object_bounds(scene, static_cast<std::uint32_t>(dice.below(objects)));
      return own.empty() ? anywhere : onto_face(own, aim_at({}, own, Aim::anywhere, dice), dice);
    }
  }
}

/// What stands for the components that are 0.
float nothing(Dice& dice) {
  return dice.sign() * (dice.one_in(2) ? 0.0f : dice.power_of_ten(-45.0f, -17.0f));
}

/// The 26 directions to the neighbours of a cell.
std::array<Vec3, 26> neighbour_directions(Dice& dice) {
  const float length = dice.one_in(8) ? dice.power_of_ten(-44.0f, -30.0f) : 1.0f;
  std::array<Vec3, 26> directions;
  for (int i = 0, cell = 0; cell < 27; ++cell) {
    const int steps[3] = {cell % 3 - 1, cell / 3 % 3 - 1, cell / 9 - 1};
    if (cell == 13) continue;
    Vec3& direction = directions[static_cast<std::size_t>(i++)];
    for (int axis = 0; axis < 3; ++axis) {
      direction[axis] = steps[axis] == 0 ? nothing(dice) : length * static_cast<float>(steps[axis]);
    }
  }
  return directions;
}

/// Rays in planes visit both sides of them; no more than that: a ray lies in two planes at most,
/// and four cells meet where they cross. Over many rays, since it crosses others besides.
Complaint compare_visits(const Subject& subject, const Forest& forest, Dice& dice) {
  const Tree& tree = choose_tree(forest, dice);
  const World world{*forest.scene, tree};
  const Vec3 extent = forest.brute.bounds().extent();
  std::vector<std::uint64_t> special, ordinary;
  for (int i = 0; i < 20; ++i) {
    const Vec3 origin = special_origin(forest, dice);
    const Vec3 moved = origin + dice.point(1e-3f) * extent;
    for (const Vec3 direction : neighbour_directions(dice)) {
      const float size = largest_component(magnitudes(direction));
      RayCost here, beside;
      subject.closest(world, {origin, direction}, here);
      subject.closest(world, {moved, direction + size * dice.point(1e-2f)}, beside);
      special.push_back(visited(here));
      ordinary.push_back(visited(beside));
    }
  }
  const std::uint64_t found = median(special), beside = median(ordinary);
  if (found <= 4 * beside) return std::nullopt;
  return fmt::format(
      "{}: expected at most 4 x {} visited nodes (the median of rays beside the "
      "planes), found a median of {}",
      describe(world), beside, found);
}

Result<Forests> own_forests(std::uint64_t seed) {
  Dice maker(seed);
  const std::array<std::shared_ptr<const Scene>, 4> scenes{
      std::make_shared<Scene>(make_cube(8, Vec3(0.0f)).scene),
      std::make_shared<Scene>(make_cube(5, Vec3(0.1f, 0.2f, 0.3f)).scene),
      std::make_shared<Scene>(make_mixed_scene(300, Vec3(0.0f), maker)),
      std::make_shared<Scene>(make_icosphere(3, Vec3(1000.0f)).scene)};
  return grow_forests(scenes);
}

}  // namespace

Result<Trial> prepare_rays_in_planes(const Setting& setting) {
  const auto forests = setting.scene ? forests_of_scene(setting) : own_forests(setting.seed);
  if (!forests) return forests.error();
  return Trial([subject = setting.subject, forests = *forests](Dice& dice) -> Complaint {
    const Forest& forest = choose_forest(forests, dice);
    if (dice.trial() % 64 == 63) return compare_visits(subject, forest, dice);
    const int leaf_size = every_leaf_size[dice.below(3)];
    const Vec3 origin = special_origin(forest, dice);
    for (const Vec3 direction : neighbour_directions(dice)) {
      auto complaint = compare_with_brute_force(subject, forest, {origin, direction}, leaf_size);
      if (complaint) return complaint;
    }
    return std::nullopt;
  });
}

}  // namespace bspview::stress
