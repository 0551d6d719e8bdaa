#include "core/scene/spd.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/scene/spd_generators.h"

namespace bspview {
namespace {

constexpr std::array generators{
    SpdGenerator{{"balls", 4}, count_balls, make_balls},
    SpdGenerator{{"gears", 4}, count_gears, make_gears},
    SpdGenerator{{"jacks", 3}, count_jacks, make_jacks},
    SpdGenerator{{"lattice", 12}, count_lattice, make_lattice},
    SpdGenerator{{"mount", 6}, count_mount, make_mount},
    SpdGenerator{{"nurbtst", 1, false}, count_nurbtst, make_nurbtst},
    SpdGenerator{{"rings", 7}, count_rings, make_rings},
    SpdGenerator{{"sample", 1, false}, count_sample, make_sample},
    SpdGenerator{{"shells", 5}, count_shells, make_shells},
    SpdGenerator{{"sombrero", 1}, count_sombrero, make_sombrero},
    SpdGenerator{{"teapot", 12}, count_teapot, make_teapot},
    SpdGenerator{{"tetra", 6}, count_tetra, make_tetra},
    SpdGenerator{{"tree", 11}, count_tree, make_tree},
};

constexpr auto scenes = [] {
  std::array<SpdScene, generators.size()> table;
  for (std::size_t i = 0; i < table.size(); ++i) table[i] = generators[i].scene;
  return table;
}();

Result<const SpdGenerator*> find_generator(std::string_view name) {
  for (const SpdGenerator& generator : generators) {
    if (generator.scene.name == name) return &generator;
  }
  std::array<std::string_view, scenes.size()> names;
  std::ranges::transform(scenes, names.begin(), &SpdScene::name);
  return Error{
      fmt::format("there is no standard scene \"{}\"; there are {}", name, fmt::join(names, ", "))};
}

std::string describe_count(double objects) {
  if (std::isinf(objects)) return "more than 1e308";
  return objects < 1e15 ? fmt::format("{:.0f}", objects) : fmt::format("{:.3g}", objects);
}

Result<void> check_size(std::string_view name, int size) {
  if (size >= 1) return {};
  return Error{fmt::format("spd:{}: size factor {} is not valid; the smallest is 1", name, size)};
}

}  // namespace

std::span<const SpdScene> spd_scenes() {
  return scenes;
}

void add_ground(Scene& scene, std::uint32_t material, float half, float z) {
  add_face(scene, material,
           std::array{Vec3(half, half, z), Vec3(-half, half, z), Vec3(-half, -half, z),
                      Vec3(half, -half, z)});
}

Result<double> count_spd_objects(std::string_view name, int size) {
  const auto generator = find_generator(name);
  if (!generator) return generator.error();
  if (const auto valid = check_size(name, size); !valid) return valid.error();
  return (*generator)->count(size);
}

Result<Scene> make_spd(std::string_view name, std::optional<int> size) {
  const auto found = find_generator(name);
  if (!found) return found.error();
  const SpdGenerator& generator = **found;
  const int factor = size.value_or(generator.scene.standard_size);
  if (const auto valid = check_size(name, factor); !valid) return valid.error();

  const double objects = generator.count(factor);
  if (objects > max_spd_objects) {
    return Error{fmt::format("spd:{}: size factor {} would make {} objects; the limit is {:.0f}",
                             name, factor, describe_count(objects), max_spd_objects)};
  }
  Scene scene;
  scene.name = generator.scene.has_size ? fmt::format("spd:{}:{}", name, factor)
                                        : fmt::format("spd:{}", name);
  scene.objects.reserve(static_cast<std::size_t>(objects));
  generator.make(scene, factor);
  return scene;
}

}  // namespace bspview
