#include "core/bsp/build.h"

#include <array>

#include "core/base/parallel.h"
#include "core/base/timer.h"
#include "core/bsp/grow.h"
#include "core/bsp/split_rules.h"

namespace bspview {
namespace {

/// A builder: its name on the command line and how it grows a tree.
struct Rule {
  std::string_view name;
  GrowTree* grow;
};

/// In the order of the enumerators of Builder.
constexpr std::array rules{
    Rule{"naive", grow_naive},
    Rule{"median", grow_median},
    Rule{"median-longest", grow_median_longest},
    Rule{"object-median", grow_object_median},
    Rule{"mb", grow_mb},
    Rule{"sah", grow_sah},
    Rule{"sah-binned", grow_sah_binned},
};

constexpr auto rule_names = [] {
  std::array<std::string_view, rules.size()> names;
  for (std::size_t i = 0; i < rules.size(); ++i) names[i] = rules[i].name;
  return names;
}();

}  // namespace

GrowTree* rule_of(Builder builder) {
  return rules[static_cast<std::size_t>(builder)].grow;
}

void grow_naive(const BuildJob&, ObjectParts parts, Branch& branch) {
  branch.nodes.push_back(Node::make_leaf(0, static_cast<std::uint32_t>(parts.size())));
  for (const ObjectPart& part : parts) branch.references.push_back(part.object);
}

std::span<const std::string_view> builder_names() {
  return rule_names;
}

std::string_view name_of(Builder builder) {
  return rule_names[static_cast<std::size_t>(builder)];
}

Result<Tree> build_tree(const BuildInput& input, const BuildParams& params, const Watch& watch,
                        InnerObjects* inner) {
  const Timer timer;
  return with_build_errors(input, [&] {
    Aabb box;
    with_threads(params.threads, [&] { box = root_box(input, watch.stop); });
    BuildJob job = make_job(input, params, box, watch.stop);
    job.inner = inner;
    BuildProgress progress(watch, input.boxes.size());
    if (watch.progress) job.progress = &progress;
    GrownTree grown;
    with_threads(params.threads, [&] {
      GrowTree* const rule = rule_of(params.builder);
      grown = grow_tree([rule](const BuildJob& one,
                               Branch& branch) { rule(one, placeable_objects(one), branch); },
                        job);
    });
    progress.tell_rest();
    return Tree{.box = job.box,
                .nodes = std::move(grown.nodes),
                .references = std::move(grown.references),
                .object_count = input.boxes.size(),
                .params = params,
                .max_depth = job.max_depth,
                .cost_intersection = static_cast<float>(job.costs.intersection),
                .naive = params.builder == Builder::naive,
                .memory_limit_reached = grown.memory_limit_reached,
                .build_seconds = timer.seconds()};
  });
}

}  // namespace bspview
