#include "core/bsp/build_job.h"

#include <numeric>
#include <vector>

#include "core/math/float_error.h"
#include "core/math/largest_coordinate.h"
#include "core/shape/outline.h"

namespace bspview {
namespace {

// Node and reference indices have 30 and 32 bits: no tree takes more than this many bytes.
constexpr std::size_t memory_cap = std::size_t{1} << 33;

/// 8 ulp of the largest coordinate: thinner cells would be rounding errors.
double smallest_width(const Aabb& box) {
  const double largest = largest_coordinate(box);
  return std::max(8.0 * 0x1p-23 * largest, double{std::numeric_limits<float>::denorm_min()});
}

}  // namespace

Aabb root_box(const BuildInput& input, const std::stop_token& stop) {
  const BuildJob job{.input = input, .stop = stop};
  std::vector<Aabb> ranges(range_count(input.boxes.size()));
  job.for_each_range(input.boxes.size(), [&](std::size_t first, std::size_t last) {
    Aabb& box = ranges[first / range_size];
    for (std::size_t i = first; i < last; ++i) {
      if (is_placeable(input.boxes[i])) box.grow(input.boxes[i]);
    }
  });
  Aabb box;
  for (const Aabb& range : ranges) box.grow(range);
  if (box.empty()) return box;
  const Vec3 largest(std::numeric_limits<float>::max());
  const Vec3 margin(1e-5f * largest_component(glm::min(box.extent(), largest)));
  return {glm::max(box.lo - margin, -largest), glm::min(box.hi + margin, largest)};
}

BuildJob make_job(const BuildInput& input, const BuildParams& params, const Aabb& root,
                  std::stop_token stop) {
  BuildJob job{.input = input,
               .box = root,
               .costs = cost_model(params, input.cost_intersection),
               .weighs_tests = input.test_cost && !params.cost_intersection,
               .stop = std::move(stop)};
  job.max_depth = effective_depth(params, input.boxes.size());
  job.leaf_size = static_cast<std::size_t>(std::max(1, params.leaf_size));
  job.clip = effective_clip(params) && input.clip;
  job.min_width = smallest_width(root);
  job.clip_margin = outline_margin(root);
  const std::size_t worth_a_task = std::max(std::size_t{512}, input.boxes.size() / 64);
  job.task_count = thread_count(params.threads) > 1 ? worth_a_task : most_objects;
  job.memory_limit = std::min(params.memory_limit, memory_cap);
  return job;
}

ObjectParts placeable_objects(const BuildJob& job) {
  const std::span<const Aabb> boxes = job.input.boxes;
  std::vector<std::size_t> places(range_count(boxes.size()) + 1, 0);
  job.for_each_range(boxes.size(), [&](std::size_t first, std::size_t last) {
    std::size_t& count = places[first / range_size + 1];
    for (std::size_t i = first; i < last; ++i) count += is_placeable(boxes[i]);
  });
  std::partial_sum(places.begin(), places.end(), places.begin());
  ObjectParts parts;
  parts.resize(places.back());
  job.for_each_range(boxes.size(), [&](std::size_t first, std::size_t last) {
    ObjectPart* to = parts.data() + places[first / range_size];
    for (std::size_t i = first; i < last; ++i) {
      if (is_placeable(boxes[i])) *to++ = {boxes[i], static_cast<std::uint32_t>(i)};
    }
  });
  return parts;
}

Split with_tests_of_leaves(const BuildJob& job, const Aabb& cell, Split split) {
  if (!std::isfinite(split.tests)) return split;
  const SplitTests tests(job.costs, cell, split.axis);
  split.tests = tests(split.position, split.left, split.right);
  return split;
}

PlaneRange::PlaneRange(const BuildJob& job, const Aabb& cell, int axis)
    : first_(round_up(cell.lo[axis] + job.min_width)),
      last_(round_down(cell.hi[axis] - job.min_width)) {}

}  // namespace bspview
