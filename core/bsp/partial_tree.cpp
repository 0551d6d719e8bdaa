#include "core/bsp/partial_tree.h"

#include <algorithm>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/timer.h"
#include "core/bsp/grow.h"
#include "core/bsp/grow_sampled.h"
#include "core/bsp/split_rules.h"

namespace bspview {
namespace {

/// The largest nodes that are put off below one with `objects` objects; 0: none is.
std::size_t deferred_size(std::size_t objects) {
  constexpr std::size_t share = 16;
  if (objects <= most_built_objects) return 0;
  if (objects <= most_tested_objects) return most_built_objects;
  return std::max(most_tested_objects, objects / share);
}

/// Prepares a job of so many objects. Planes that cut little off what holds the most leave less to
/// build where rays go; only trees of `sah` need not be those of build_tree.
void put_off(BuildJob& job, Builder builder, std::size_t objects) {
  job.deferred_size = deferred_size(objects);
  job.costs.counts_all = job.deferred_size > 0 && builder == Builder::sah;
}

GrowBranch upper_rule(Builder builder, const BuildJob& job, const PartsView& parts) {
  if (builder == Builder::sah && is_worth_sampling(job, parts.size())) {
    return [&](const BuildJob& one, Branch& branch) { grow_sampled(one, parts, branch); };
  }
  const bool by_bins = builder == Builder::sah && job.deferred_size > 0;
  GrowTree* const rule = rule_of(by_bins ? Builder::sah_binned : builder);
  return [&, rule](const BuildJob& one, Branch& branch) { rule(one, parts.list(one), branch); };
}

PartialTree grow_partial(const BuildJob& job, const BuildParams& params, const PartsView& parts) {
  GrownTree grown = grow_tree(upper_rule(params.builder, job, parts), job);
  std::ranges::sort(grown.deferred, {}, &DeferredLeaf::node);
  PartialTree partial{.tree = {.box = job.box,
                               .nodes = std::move(grown.nodes),
                               .references = std::move(grown.references),
                               .object_count = job.input.boxes.size(),
                               .params = params,
                               .max_depth = job.max_depth,
                               .cost_intersection = static_cast<float>(job.costs.intersection),
                               .memory_limit_reached = grown.memory_limit_reached},
                      .deferred = std::move(grown.deferred)};
  for (const DeferredLeaf& leaf : partial.deferred) partial.tree.unbuilt.push_back(leaf.node);
  return partial;
}

}  // namespace

Result<PartialTree> build_partial_tree(const BuildInput& input, const BuildParams& params,
                                       std::stop_token stop) {
  const Timer timer;
  return with_build_errors(input, [&] {
    PartialTree partial;
    with_threads(params.threads, [&] {
      BuildJob job = make_job(input, params, root_box(input, stop), stop);
      put_off(job, params.builder, input.boxes.size());
      partial = grow_partial(job, params, PartsView(input));
    });
    partial.tree.build_seconds = timer.seconds();
    return partial;
  });
}

Result<PartialTree> build_deferred(const BuildInput& input, const Tree& whole,
                                   const DeferredLeaf& leaf, std::size_t memory_limit) {
  const Timer timer;
  return with_build_errors(input, [&] {
    BuildParams params = whole.params;
    params.threads = 1;
    params.memory_limit = memory_limit;
    BuildJob job = make_job(input, params, whole.box, {});
    job.box = leaf.place.cell;
    job.depth = leaf.place.depth;
    put_off(job, params.builder, leaf.parts.size());
    PartialTree partial;
    with_threads(1, [&] { partial = grow_partial(job, whole.params, PartsView(leaf.parts)); });
    partial.tree.build_seconds = timer.seconds();
    return partial;
  });
}

}  // namespace bspview
