#include "core/bsp/build.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <new>

#include "core/base/parallel.h"
#include "core/base/timer.h"
#include "core/bsp/split_rules.h"
#include "core/shape/outline.h"

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

// Nodes count their objects with 30 bits.
constexpr std::size_t most_objects = (std::size_t{1} << 30) - 1;

// Node and reference indices have 30 and 32 bits: no tree takes more than this many bytes.
constexpr std::size_t memory_cap = std::size_t{1} << 33;

std::vector<ObjectPart> placeable_objects(const BuildJob& job) {
  const std::span<const Aabb> boxes = job.input.boxes;
  std::vector<ObjectPart> parts;
  parts.reserve(boxes.size());
  job.for_each(boxes.size(), light_steps, [&](std::size_t i) {
    if (is_placeable(boxes[i])) parts.push_back({boxes[i], static_cast<std::uint32_t>(i)});
  });
  return parts;
}

/// The union of the boxes, each side moved outwards by 1e-5 x the largest one.
Aabb root_box(const BuildJob& job) {
  const std::span<const Aabb> boxes = job.input.boxes;
  Aabb box;
  job.for_each(boxes.size(), light_steps, [&](std::size_t i) {
    if (is_placeable(boxes[i])) box.grow(boxes[i]);
  });
  if (box.empty()) return box;
  const Vec3 largest(std::numeric_limits<float>::max());
  const Vec3 margin(1e-5f * largest_component(glm::min(box.extent(), largest)));
  return {glm::max(box.lo - margin, -largest), glm::min(box.hi + margin, largest)};
}

/// 8 ulp of the largest coordinate: thinner cells would be rounding errors.
double smallest_width(const Aabb& box) {
  const double largest = largest_component(glm::max(magnitudes(box.lo), magnitudes(box.hi)));
  return std::max(8.0 * 0x1p-23 * largest, double{std::numeric_limits<float>::denorm_min()});
}

BuildJob make_job(const BuildInput& input, const BuildParams& params, std::stop_token stop) {
  BuildJob job{.input = input, .costs = cost_model(params), .stop = std::move(stop)};
  job.box = root_box(job);
  job.max_depth = effective_depth(params, input.boxes.size());
  job.leaf_size = static_cast<std::size_t>(std::max(1, params.leaf_size));
  job.clip = effective_clip(params) && input.clip;
  job.min_width = smallest_width(job.box);
  job.clip_margin = outline_margin(job.box);
  const std::size_t worth_a_task = std::max(std::size_t{512}, input.boxes.size() / 64);
  job.task_count = thread_count(params.threads) > 1 ? worth_a_task : most_objects;
  job.memory_limit = std::min(params.memory_limit, memory_cap);
  return job;
}

struct GrownTree {
  std::vector<Node> nodes;
  std::vector<std::uint32_t> references;
  bool memory_limit_reached = false;
};

/// The tree down to `depth`; nullopt when it passes the memory limit. A lone root never does.
std::optional<GrownTree> grow_to(int depth, const Rule& rule, BuildJob job) {
  MemoryMeter meter(job.memory_limit);
  if (depth > 0) job.meter = &meter;
  job.max_depth = depth;
  Branch branch;
  try {
    rule.grow(job, placeable_objects(job), branch);
  } catch (const MemoryLimitPassed&) {
    return {};
  }
  if (job.inner) job.inner->lists = std::move(branch.inner);
  return GrownTree{std::move(branch.nodes), std::move(branch.references)};
}

/// The whole tree, or else the deepest one that the memory limit allows.
GrownTree grow_tree(const Rule& rule, BuildJob job) {
  if (auto whole = grow_to(job.max_depth, rule, job)) return *std::move(whole);
  if (job.inner) job.inner->meter.give_up();
  job.inner = nullptr;
  int fitting = 0, too_deep = job.max_depth;
  std::optional<GrownTree> cut;
  while (too_deep - fitting > 1) {
    const int depth = fitting + (too_deep - fitting) / 2;
    cut.reset();  // never two trees at once
    cut = grow_to(depth, rule, job);
    (cut ? fitting : too_deep) = depth;
  }
  if (!cut) cut = grow_to(fitting, rule, job);
  cut->memory_limit_reached = true;
  return *std::move(cut);
}

}  // namespace

void grow_naive(const BuildJob&, std::vector<ObjectPart> parts, Branch& branch) {
  branch.nodes.push_back(Node::make_leaf(0, static_cast<std::uint32_t>(parts.size())));
  for (const ObjectPart& part : parts) branch.references.push_back(part.object);
}

bool is_placeable(const Aabb& box) {
  const auto finite = [](Vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  };
  return !box.empty() && finite(box.lo) && finite(box.hi);
}

std::span<const std::string_view> builder_names() {
  return rule_names;
}

std::string_view name_of(Builder builder) {
  return rule_names[static_cast<std::size_t>(builder)];
}

Result<Tree> build_tree(const BuildInput& input, const BuildParams& params, std::stop_token stop,
                        InnerObjects* inner) {
  const Timer timer;
  if (input.boxes.size() > most_objects) {
    return Error{
        fmt::format("a tree holds at most {} objects, not {}", most_objects, input.boxes.size())};
  }
  try {
    BuildJob job = make_job(input, params, std::move(stop));
    job.inner = inner;
    const Rule& rule = rules[static_cast<std::size_t>(params.builder)];
    GrownTree grown;
    with_threads(params.threads, [&] { grown = grow_tree(rule, job); });
    return Tree{.box = job.box,
                .nodes = std::move(grown.nodes),
                .references = std::move(grown.references),
                .object_count = input.boxes.size(),
                .params = params,
                .max_depth = job.max_depth,
                .naive = params.builder == Builder::naive,
                .memory_limit_reached = grown.memory_limit_reached,
                .build_seconds = timer.seconds()};
  } catch (const BuildStopped&) {
    return Error{"stopped"};
  } catch (const InnerObjectsPassed&) {
    return Error{"what the inner nodes hold takes too much memory"};
  } catch (const std::bad_alloc&) {
    return Error{"not enough memory for the tree"};
  }
}

}  // namespace bspview
