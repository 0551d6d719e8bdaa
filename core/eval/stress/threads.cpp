// T21: the number of threads changes neither a tree nor a picture nor a count.

#include <fmt/format.h>

#include "core/eval/delta.h"
#include "core/eval/stress/rows.h"
#include "core/render/render.h"
#include "core/render/scene_tree.h"
#include "core/scene/spd.h"

namespace bspview::stress {
namespace {

/// The standard scenes, small.
Result<std::vector<std::shared_ptr<const Scene>>> small_scenes() {
  std::vector<std::shared_ptr<const Scene>> scenes;
  for (const SpdScene& spd : spd_scenes()) {
    auto scene = make_spd(
        spd.name, spd.has_size ? std::optional(std::min(spd.standard_size, 2)) : std::nullopt);
    if (!scene) return scene.error();
    scenes.push_back(std::make_shared<Scene>(*std::move(scene)));
  }
  return scenes;
}

/// A tree and a picture on some number of threads.
struct Outcome {
  Tree tree;
  CountedImage counted;
  Image plain;
};

Result<Outcome> render(const Scene& scene, const BuildParams& build, const RenderParams& params) {
  auto tree = build_scene_tree(scene, build);
  if (!tree) return tree.error();
  auto counted = render_counted({scene, *tree}, scene.camera, params);
  if (!counted) return counted.error();
  auto plain = render_image({scene, *tree}, scene.camera, params);
  if (!plain) return plain.error();
  return Outcome{*std::move(tree), *std::move(counted), *std::move(plain)};
}

std::string difference(const Outcome& one, const Outcome& many) {
  if (one.tree.nodes != many.tree.nodes || one.tree.references != many.tree.references) {
    return "the tree";
  }
  if (one.counted.image != many.counted.image || one.plain != many.plain) return "the picture";
  if (one.counted.image != one.plain) return "the counted picture from the plain one";
  const auto delta = [](const Outcome& outcome) {
    return compute_delta(tree_stats(outcome.tree), outcome.tree.object_count,
                         outcome.counted.counts);
  };
  if (one.counted.counts != many.counted.counts || delta(one) != delta(many)) return "a count";
  return "";
}

}  // namespace

Result<Trial> prepare_threads(const Setting& setting) {
  auto scenes = setting.scene ? std::vector<std::shared_ptr<const Scene>>{setting.scene}
                              : std::vector<std::shared_ptr<const Scene>>{};
  if (!setting.scene) {
    auto small = small_scenes();
    if (!small) return small.error();
    scenes = *std::move(small);
  }
  return Trial([scenes](Dice& dice) -> Complaint {
    const auto pick = static_cast<std::size_t>(dice.trial()) % scenes.size();
    const Scene& scene = *scenes[pick];
    BuildParams build{.leaf_size = 1 + dice.below(4), .threads = 1};
    build.builder =
        static_cast<Builder>(1 + dice.below(static_cast<int>(builder_names().size()) - 1));
    RenderParams params{.width = 24 + dice.below(40), .height = 24 + dice.below(40), .threads = 1};
    params.spd_rules = dice.one_in(2);
    params.samples = 1 + dice.below(2);
    const auto one = render(scene, build, params);
    build.threads = params.threads = 2 + dice.below(7);
    const auto many = render(scene, build, params);
    if (!one || !many) return (one ? many : one).error().message;
    const std::string differs = difference(*one, *many);
    if (differs.empty()) return std::nullopt;
    return fmt::format("{} by {}, {} x {}: 1 and {} threads differ in {}", scene.name,
                       name_of(build.builder), params.width, params.height, params.threads,
                       differs);
  });
}

}  // namespace bspview::stress
