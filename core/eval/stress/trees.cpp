// T11 and T12: trees over bounds that are one float apart, and over what builders find hard.

#include <fmt/format.h>

#include <array>

#include "core/bsp/event_list.h"
#include "core/bsp/stats.h"
#include "core/bsp/validate.h"
#include "core/eval/stress/rows.h"
#include "core/math/float_error.h"

namespace bspview::stress {
namespace {

using Boxes = std::vector<Aabb>;

/// Objects that are their own boxes. The input points into `boxes`.
BuildInput input_of(const Boxes& boxes) {
  return {boxes, [&boxes](std::uint32_t object, const Aabb& cell) {
            return intersection(boxes[object], cell);
          }};
}

/// Bounds a few floats beside one of some common values.
Boxes boxes_ulps_apart(std::size_t count, Dice& dice) {
  const std::array<float, 4> values{-1.0f, dice.between(-1.0f, 1.0f), 0.0f, 1.0f};
  const auto bound = [&] {
    float x = values[static_cast<std::size_t>(dice.below(4))];
    for (int steps = dice.below(4); steps > 0; --steps) x = next_up(x);
    return x;
  };
  Boxes boxes(count);
  for (Aabb& box : boxes) {
    box.grow({bound(), bound(), bound()});
    box.grow({bound(), bound(), bound()});
  }
  return boxes;
}

/// What the sweep counts on both sides of a plane must be what the split deals out.
Complaint compare_counts(const Boxes& boxes, Dice& dice) {
  const BuildInput input = input_of(boxes);
  BuildJob job{.input = input, .clip = dice.one_in(2)};
  std::vector<ObjectPart> parts;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    parts.push_back({boxes[i], i});
    job.box.grow(boxes[i]);
  }
  ScratchStack scratch;
  EventList list(job, parts, scratch);
  const int axis = dice.below(3);
  const std::span<const Event> events = list.events(axis);
  const float plane =
      events[static_cast<std::size_t>(dice.below(static_cast<int>(events.size())))].position();
  Split split{.axis = axis, .position = plane};
  std::size_t left = 0, right = 0;
  for (const Event event : events) {
    split.left += event.is_start() && event.position() < plane;
    split.right += event.is_end() && event.position() > plane;
  }
  for (const Aabb& box : boxes) {
    left += box.lo[axis] <= plane;
    right += box.hi[axis] >= plane;
  }
  const CellSplit cut(split, job.box);
  const EventList other = list.split(cut, scratch);
  const std::size_t dealt_left = cut.keeps_left() ? list.count() : other.count();
  const std::size_t dealt_right = cut.keeps_left() ? other.count() : list.count();
  const bool same =
      split.left == left && split.right == right && dealt_left == left && dealt_right == right;
  if (same) return std::nullopt;
  return fmt::format(
      "plane {:a} on axis {}: counted {} and {}, dealt {} and {}, expected {} and {}", plane, axis,
      split.left, split.right, dealt_left, dealt_right, left, right);
}

BuildParams random_params(Dice& dice) {
  const auto builders = static_cast<int>(builder_names().size());
  return {.builder = static_cast<Builder>(dice.below(builders)),
          .max_depth = dice.below(12),
          .leaf_size = 1 + dice.below(4),
          .clip = dice.one_in(2),
          .threads = 1};
}

Complaint build_and_validate(const Boxes& boxes, const BuildParams& params) {
  const BuildInput input = input_of(boxes);
  const auto tree = build_tree(input, params);
  const auto valid = tree ? validate(*tree, input) : Result<void>(tree.error());
  if (valid) return std::nullopt;
  return fmt::format("{} boxes by {}: expected a valid tree, found: {}", boxes.size(),
                     name_of(params.builder), valid.error().message);
}

enum class Hardness { identical, concentric, collinear, needles };
constexpr std::array<std::string_view, 4> hardness_names{"identical", "concentric", "collinear",
                                                         "needle"};

Boxes hard_boxes(Hardness hardness, std::size_t count, Dice& dice) {
  Boxes boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const float part = static_cast<float>(i + 1) / static_cast<float>(count);
    const Vec3 centre = hardness == Hardness::needles     ? dice.point(1.0f)
                        : hardness == Hardness::collinear ? Vec3(part)
                                                          : Vec3(0.0f);
    Vec3 half(hardness == Hardness::concentric ? part : 1e-6f);
    if (hardness == Hardness::needles) half[static_cast<int>(i % 3)] = 1.0f;
    boxes.push_back({centre - half, centre + half});
  }
  return boxes;
}

/// The first trials are small, so that short runs are short.
constexpr std::int64_t small_trials = 24;

}  // namespace

Result<Trial> prepare_close_events(const Setting&) {
  return Trial([](Dice& dice) -> Complaint {
    const int most = dice.one_in(8) ? 500 : 30;
    const Boxes boxes = boxes_ulps_apart(2 + static_cast<std::size_t>(dice.below(most)), dice);
    if (auto complaint = compare_counts(boxes, dice)) return complaint;
    return build_and_validate(boxes, random_params(dice));
  });
}

Result<Trial> prepare_hard_builds(const Setting&) {
  return Trial([](Dice& dice) -> Complaint {
    const auto hardness = static_cast<Hardness>(dice.trial() % 4);
    const auto builder =
        static_cast<Builder>(static_cast<std::size_t>(dice.trial() / 4) % builder_names().size());
    const bool small = dice.trial() < small_trials;
    const Boxes boxes = hard_boxes(hardness, small ? 1000 : 100'000, dice);
    BuildParams params{.builder = builder, .max_depth = 1'000'000'000};
    params.memory_limit = std::size_t{1} << 24;
    const auto tree = build_tree(input_of(boxes), params);
    const std::string what =
        fmt::format("{} {} boxes by {}", boxes.size(),
                    hardness_names[static_cast<std::size_t>(hardness)], name_of(builder));
    if (!tree) return what + ": " + tree.error().message;
    const int depth = tree_stats(*tree).deepest_leaf;
    if (depth <= depth_cap && tree->bytes() <= params.memory_limit) return std::nullopt;
    return fmt::format("{}: expected at most {} bytes and depth {}, found {} and {}", what,
                       params.memory_limit, depth_cap, tree->bytes(), depth);
  });
}

}  // namespace bspview::stress
