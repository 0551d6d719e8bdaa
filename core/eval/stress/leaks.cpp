// T05 to T07: no ray passes through a closed mesh, and every tree finds what brute force finds.

#include <fmt/format.h>

#include <array>

#include "core/eval/stress/forest.h"
#include "core/eval/stress/mesh.h"
#include "core/eval/stress/rows.h"
#include "core/eval/stress/scenes.h"
#include "core/render/scene_tree.h"

namespace bspview::stress {
namespace {

constexpr std::array places{Vec3(0.0f), Vec3(1000.0f), Vec3(148376.0f, 1234.0f, -223423.0f)};

std::vector<ClosedMesh> closed_meshes() {
  std::vector<ClosedMesh> meshes;
  for (const Vec3 place : places) {
    meshes.push_back(make_icosphere(3, place));
    meshes.push_back(make_torus(20, place));
    meshes.push_back(make_cube(8, place));
    meshes.push_back(make_square_globe(12, 20, place));
  }
  return meshes;
}

/// A closed mesh with its trees.
struct Wood {
  ClosedMesh mesh;
  SharedForest forest;
};

Result<Wood> grow_wood(ClosedMesh mesh) {
  const auto scene = std::make_shared<Scene>(mesh.scene);
  auto forest = grow_forest(scene, every_leaf_size);
  if (!forest) return forest.error();
  return Wood{std::move(mesh), *std::move(forest)};
}

/// From this trial on, every 8th one is on a mesh of 159,200 triangles: short runs need not build
/// its trees.
constexpr std::int64_t first_large_trial = 100'000;
bool is_large_trial(std::int64_t trial) {
  return trial >= first_large_trial && trial % 8 == 0;
}

Aim aim_of(std::int64_t trial) {
  return static_cast<Aim>(trial % aim_count);
}

/// With brute force, and now and then with exact arithmetic. Polygons that are not quite planar
/// have no exact surface: neighbours meet a ray through their common edge at different distances.
Complaint compare_with_both(const Subject& subject, const Forest& forest, const Ray& ray,
                            Dice& dice) {
  if (forest.scene->planes.empty() && dice.one_in(16)) {
    if (auto complaint = compare_with_reference(subject, forest, ray)) return complaint;
  }
  return compare_with_brute_force(subject, forest, ray, choose_leaf_size(dice));
}

/// A cube in a cube: walls with room on both sides, so that planes are put beside them.
Scene nested_cubes(int n, Vec3 centre) {
  Scene scene = make_cube(n, centre).scene;
  for (std::size_t i = 0, faces = scene.faces.size(); i < faces; ++i) {
    const auto outer = vertices_of(scene, scene.faces[i]);
    std::vector<Vec3> inner(outer.begin(), outer.end());
    for (Vec3& vertex : inner) vertex = centre + 0.4f * (vertex - centre);
    add_face(scene, 0, inner);
  }
  return scene;
}

Result<Trial> prepare_scene_trees(const Setting& setting) {
  const auto forest = setting.forest();
  if (!forest) return forest.error();
  return Trial([subject = setting.subject, forest = *forest](Dice& dice) {
    const Aabb& box = forest->brute.bounds();
    const Vec3 target = aim_at(*forest->scene, box, aim_of(dice.trial()), dice);
    return compare_with_both(subject, *forest, ray_towards(target, box, dice), dice);
  });
}

}  // namespace

Result<Trial> prepare_closed_meshes(const Setting& setting) {
  struct Mesh {
    ClosedMesh closed;
    Tree tree;
  };
  const auto meshes = std::make_shared<std::vector<Mesh>>();
  for (ClosedMesh& closed : closed_meshes()) {
    auto tree = build_scene_tree(closed.scene, {.builder = Builder::naive});
    if (!tree) return tree.error();
    meshes->push_back({std::move(closed), *std::move(tree)});
  }
  return Trial([subject = setting.subject, meshes](Dice& dice) -> Complaint {
    const Mesh& mesh =
        (*meshes)[static_cast<std::size_t>(dice.below(static_cast<int>(meshes->size())))];
    const Ray ray = ray_through(mesh.closed, aim_of(dice.trial()), dice);
    RayCost cost;
    if (subject.closest({mesh.closed.scene, mesh.tree}, ray, cost)) return std::nullopt;
    return fmt::format("{} around {}: {}: expected a hit, found nothing", mesh.closed.scene.name,
                       mesh.closed.centre.x, describe(ray));
  });
}

Result<Trial> prepare_every_tree(const Setting& setting) {
  if (setting.scene) return prepare_scene_trees(setting);
  const auto woods = std::make_shared<std::vector<Wood>>();
  std::vector<ClosedMesh> meshes = closed_meshes();
  Dice maker(setting.seed);
  for (const Vec3 place : {Vec3(0.0f), Vec3(100.0f)}) {
    meshes.push_back({make_mixed_scene(300, place, maker), place});
    meshes.push_back({make_scene_without_polygons(300, place, maker), place});
  }
  const bool large = setting.last_trial >= first_large_trial;
  if (large) meshes.push_back(make_globe(200, 400, Vec3(0.1f, 0.2f, 0.3f)));
  for (ClosedMesh& mesh : meshes) {
    auto wood = grow_wood(std::move(mesh));
    if (!wood) return wood.error();
    woods->push_back(*std::move(wood));
  }
  const auto small = static_cast<int>(woods->size()) - (large ? 1 : 0);
  return Trial([subject = setting.subject, woods, small](Dice& dice) {
    const bool on_large = is_large_trial(dice.trial());
    const Wood& wood = (*woods)[static_cast<std::size_t>(on_large ? small : dice.below(small))];
    const Aim aim = aim_of(dice.trial() / 8);
    const Aabb& box = wood.forest->brute.bounds();
    const Ray ray = dice.one_in(2)
                        ? ray_through(wood.mesh, aim, dice)
                        : ray_towards(aim_at(wood.mesh.scene, box, aim, dice), box, dice);
    return compare_with_both(subject, *wood.forest, ray, dice);
  });
}

Result<Trial> prepare_cube_grids(const Setting& setting) {
  std::vector<std::shared_ptr<const Scene>> scenes;
  for (const Vec3 centre : {Vec3(0.0f), Vec3(0.1f, 0.2f, 0.3f), Vec3(1000.0f)}) {
    for (const int n : {1, 8}) scenes.push_back(std::make_shared<Scene>(nested_cubes(n, centre)));
  }
  const auto forests = grow_forests(scenes);
  if (!forests) return forests.error();
  return Trial([subject = setting.subject, forests = *forests](Dice& dice) {
    const Forest& forest = choose_forest(forests, dice);
    const Aabb& box = forest.brute.bounds();
    Ray ray = ray_towards(aim_at(*forest.scene, box, aim_of(dice.trial()), dice), box, dice);
    if (dice.one_in(4)) ray.direction[dice.below(3)] = 0.0f;
    if (ray.direction == Vec3(0.0f)) ray.direction = dice.direction();
    return compare_with_brute_force(subject, forest, ray, choose_leaf_size(dice));
  });
}

}  // namespace bspview::stress
