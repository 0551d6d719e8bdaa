// T21: the number of threads changes neither a tree nor a picture nor a count, whatever the picture
// is made with: walks that count, walks that do not and those of a picture that grows are compiled
// apart, for each arithmetic.

#include <fmt/format.h>

#include "core/eval/delta.h"
#include "core/eval/stress/rows.h"
#include "core/render/accelerator.h"
#include "core/render/render.h"
#include "core/render/scene_tree.h"
#include "core/scene/spd.h"

namespace bspview::stress {
namespace {

using Scenes = std::vector<std::shared_ptr<const Scene>>;

/// The standard scenes, small.
Result<Scenes> small_scenes() {
  Scenes scenes;
  for (const SpdScene& spd : spd_scenes()) {
    auto scene = make_spd(
        spd.name, spd.has_size ? std::optional(std::min(spd.standard_size, 2)) : std::nullopt);
    if (!scene) return scene.error();
    scenes.push_back(std::make_shared<Scene>(*std::move(scene)));
  }
  return scenes;
}

/// Some trees are cut to memory, which must not depend on threads either.
BuildParams random_build(Dice& dice) {
  BuildParams build{.leaf_size = 1 + dice.below(4), .threads = 1};
  build.builder =
      static_cast<Builder>(1 + dice.below(static_cast<int>(builder_names().size()) - 1));
  build.memory_limit = std::size_t{1} << (16 + dice.below(10));
  return build;
}

/// Any element of an enumeration with those names.
template <class Enum>
Enum any_of(std::span<const std::string_view> names, Dice& dice) {
  return static_cast<Enum>(dice.below(static_cast<int>(names.size())));
}

RenderParams random_picture(Dice& dice) {
  RenderParams picture{.width = 24 + dice.below(40), .height = 24 + dice.below(40), .threads = 1};
  picture.spd_rules = dice.one_in(3);
  picture.samples = 1 + dice.below(2);
  if (dice.one_in(2)) picture.traversal = any_of<Traversal>(traversal_names(), dice);
  if (dice.one_in(2)) picture.arithmetic = any_of<Arithmetic>(arithmetic_names(), dice);
  if (dice.one_in(2)) picture.offset = any_of<OffsetRule>(offset_rule_names(), dice);
  if (dice.one_in(3)) picture.cutoff = dice.between(0.0f, 0.1f);
  if (dice.one_in(4)) {
    picture.samples = 12;
    picture.adaptive = dice.between(0.0f, 0.05f);
  }
  return picture;
}

/// A tree and a picture on some number of threads.
struct Outcome {
  Tree tree;
  CountedImage counted;
  Image plain;
  std::vector<Vec3> grown;  ///< colours of the progressive picture
};

/// The progressive picture has no corner rays: only without them is it the plain one.
std::vector<Vec3> grow_picture(const World& world, const RenderParams& params) {
  std::vector<Vec3> colors;
  if (params.spd_rules) return colors;
  render_progressive(world, world.scene.camera, params, {},
                     [&](const Frame& frame) { colors = frame.color; });
  return colors;
}

Result<Outcome> render(const Scene& scene, const BuildParams& build, const RenderParams& params) {
  auto tree = build_scene_tree(scene, build);
  if (!tree) return tree.error();
  const FastWorld fast({scene, *tree});
  auto counted = render_counted({scene, *tree}, scene.camera, params);
  if (!counted) return counted.error();
  auto plain = render_image(fast.world(), scene.camera, params);
  if (!plain) return plain.error();
  auto grown = grow_picture(fast.world(), params);
  return Outcome{*std::move(tree), *std::move(counted), *std::move(plain), std::move(grown)};
}

std::string difference(const Outcome& one, const Outcome& many) {
  if (one.tree.nodes != many.tree.nodes || one.tree.references != many.tree.references) {
    return "the tree";
  }
  if (one.counted.image != many.counted.image || one.plain != many.plain) return "the picture";
  if (one.counted.image != one.plain) return "the counted picture from the plain one";
  if (one.grown != many.grown) return "the progressive picture";
  if (!one.grown.empty() && one.grown != one.plain.pixels) {
    return "the progressive picture from the plain one";
  }
  const auto delta = [](const Outcome& outcome) {
    return compute_delta(tree_stats(outcome.tree), outcome.tree.object_count,
                         outcome.counted.counts);
  };
  if (one.counted.counts != many.counted.counts || delta(one) != delta(many)) return "a count";
  return "";
}

std::string describe(const BuildParams& build, const RenderParams& picture) {
  return fmt::format(
      "{}, leaf size {}, {} bytes; {} x {}, {} samples, spd rules {}, {}, {}, {}, cutoff {:a}, "
      "adaptive {:a}",
      name_of(build.builder), build.leaf_size, build.memory_limit, picture.width, picture.height,
      picture.samples, picture.spd_rules, name_of(picture.traversal), name_of(picture.arithmetic),
      name_of(picture.offset), picture.cutoff, picture.adaptive);
}

}  // namespace

Result<Trial> prepare_threads(const Setting& setting) {
  auto scenes = setting.scene ? Result<Scenes>(Scenes{setting.scene}) : small_scenes();
  if (!scenes) return scenes.error();
  return Trial([scenes = *std::move(scenes)](Dice& dice) -> Complaint {
    const Scene& scene = *scenes[static_cast<std::size_t>(dice.trial()) % scenes.size()];
    BuildParams build = random_build(dice);
    RenderParams picture = random_picture(dice);
    const auto one = render(scene, build, picture);
    build.threads = picture.threads = 2 + dice.below(7);
    const auto many = render(scene, build, picture);
    if (!one || !many) return (one ? many : one).error().message;
    const std::string differs = difference(*one, *many);
    if (differs.empty()) return std::nullopt;
    return fmt::format("{} by {}: 1 and {} threads differ in {}", scene.name,
                       describe(build, picture), picture.threads, differs);
  });
}

}  // namespace bspview::stress
