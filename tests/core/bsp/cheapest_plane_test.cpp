#include <gtest/gtest.h>

#include "core/bsp/bin_planes.h"
#include "core/bsp/event_sweep.h"
#include "core/bsp/few_planes.h"
#include "core/math/float_error.h"
#include "tests/support/box_sets.h"
#include "tests/support/random.h"

namespace bspview {
namespace {

/// By definition: every plane next to a side of a box, and the outermost ones in range, where both
/// sides are divided further; priced as leaves.
Split cheapest_of_all(const BuildJob& job, std::span<const ObjectPart> parts) {
  Split best{.tests = std::numeric_limits<double>::infinity()};
  for (int axis = 0; axis < 3; ++axis) {
    const PlaneRange range(job, job.box, axis);
    const SplitTests tests(job.costs, job.box, axis);
    std::vector<float> planes{range.first(), range.last()};
    for (const ObjectPart& part : parts) {
      planes.push_back(next_down(part.box.lo[axis]));
      planes.push_back(next_up(part.box.hi[axis]));
    }
    std::ranges::sort(planes);
    for (const float plane : planes) {
      Split split{.axis = axis, .position = plane};
      for (const ObjectPart& part : parts) {
        split.left += part.box.lo[axis] <= plane;
        split.right += part.box.hi[axis] >= plane;
      }
      split.tests = tests.divided(plane, plane, split.left, split.right);
      if (range.holds(plane) && split.tests < best.tests) best = split;
    }
  }
  return with_tests_of_leaves(job, job.box, best);
}

/// A job over some boxes, in a cell of their own.
struct TestJob {
  TestJob(const std::vector<Aabb>& boxes, const Aabb& cell, const CostModel& costs)
      : job{.input = none, .box = cell, .costs = costs} {
    job.min_width = 0x1p-20;
    for (const Aabb& box : boxes) {
      const Aabb part = intersection(box, cell);
      if (!part.empty()) parts.push_back({part, static_cast<std::uint32_t>(parts.size())});
    }
  }

  BuildInput none;
  BuildJob job;
  std::vector<ObjectPart> parts;
};

void expect_cheapest(const TestJob& test, const Split& split, const std::string& trial) {
  const Split expected = cheapest_of_all(test.job, test.parts);
  ASSERT_EQ(split.tests, expected.tests) << trial;
  if (!std::isfinite(expected.tests)) return;
  ASSERT_EQ(split.axis, expected.axis) << trial;
  ASSERT_EQ(split.position, expected.position) << trial;
}

/// There may be none where none pays.
void expect_cheapest_of_few(const TestJob& test, const Split& split, const std::string& trial) {
  if (std::isfinite(split.tests)) return expect_cheapest(test, split, trial);
  const double saving =
      static_cast<double>(test.parts.size()) - cheapest_of_all(test.job, test.parts).tests;
  ASSERT_LT(saving, test.job.costs.least_saving()) << trial;
}

Split find_swept(const TestJob& test) {
  ScratchStack scratch;
  return cheapest_of_events(test.job, EventList(test.job, test.parts, scratch), test.job.box);
}

Split find_among_few(const TestJob& test) {
  std::vector<FewBox> boxes;
  for (const ObjectPart& part : test.parts) boxes.push_back(few_box(part.box, 1.0f));
  return cheapest_of_few(test.job, boxes, test.job.box);
}

const CostModel costs{.traversal = 1.0, .intersection = 1.5, .empty_factor = 0.9};
const Aabb part_of_the_cube{Vec3(-0.7f, -0.5f, 0.0f), Vec3(0.3f, 0.9f, 0.8f)};

TEST(CheapestPlane, IsThatOfAllOfAFewBoxes) {
  test::Random random(1);
  for (int trial = 0; trial < 3000; ++trial) {
    const int count = 1 + random.below(most_few_parts);
    const test::BoxSet set = test::random_boxes(count, static_cast<std::uint64_t>(trial));
    const TestJob test(set.boxes(), part_of_the_cube, costs);
    const std::string name = "trial " + std::to_string(trial);
    expect_cheapest_of_few(test, find_among_few(test), name);
    expect_cheapest(test, find_swept(test), name);
  }
}

TEST(CheapestPlane, IsThatOfAllOfManyBoxes) {
  for (int trial = 0; trial < 20; ++trial) {
    const test::BoxSet set = test::random_boxes(100 + 50 * trial, 7);
    const TestJob test(set.boxes(), part_of_the_cube, costs);
    expect_cheapest(test, find_swept(test), "trial " + std::to_string(trial));
  }
}

TEST(CheapestPlane, IsTheLowestAmongEquals) {
  test::Random random(2);
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<Aabb> boxes;
    for (int i = 1 + random.below(most_few_parts); i > 0; --i) {
      const auto on_lattice = [&] { return 0.25f * static_cast<float>(random.below(9) - 4); };
      Aabb box;
      box.grow({on_lattice(), on_lattice(), on_lattice()});
      box.grow({on_lattice(), on_lattice(), on_lattice()});
      boxes.push_back(box);
    }
    const TestJob test(boxes, {Vec3(-1.0f), Vec3(1.0f)}, costs);
    const std::string name = "trial " + std::to_string(trial);
    expect_cheapest_of_few(test, find_among_few(test), name);
    expect_cheapest(test, find_swept(test), name);
  }
}

TEST(CheapestPlane, IsThatOfAllOfHardBoxes) {
  for (const int count : {20, 200}) {
    for (const test::HardCase& hard : test::hard_cases(count, 3)) {
      std::vector<Aabb> boxes;
      for (const Aabb& box : hard.set.boxes()) {
        if (is_placeable(box)) boxes.push_back(box);
      }
      Aabb cell;
      for (const Aabb& box : boxes) cell.grow(box);
      const TestJob test(boxes, cell, costs);
      if (test.parts.size() <= most_few_parts)
        expect_cheapest_of_few(test, find_among_few(test), hard.name);
      expect_cheapest(test, find_swept(test), hard.name);
    }
  }
}

TEST(CheapestPlane, ABoxThatCostsMoreIsAsGoodAsSeveral) {
  test::Random random(4);
  for (int trial = 0; trial < 1000; ++trial) {
    const test::BoxSet set = test::random_boxes(10, static_cast<std::uint64_t>(trial));
    const TestJob test(set.boxes(), part_of_the_cube, costs);
    std::vector<FewBox> weighed, several;
    for (const ObjectPart& part : test.parts) {
      const int tests = 1 + random.below(3);
      weighed.push_back(few_box(part.box, static_cast<float>(tests)));
      several.insert(several.end(), static_cast<std::size_t>(tests), few_box(part.box, 1.0f));
    }
    const Split one = cheapest_of_few(test.job, weighed, test.job.box);
    const Split same = cheapest_of_few(test.job, several, test.job.box);
    ASSERT_EQ(one.tests, same.tests) << "trial " << trial;
    ASSERT_EQ(one.axis, same.axis) << "trial " << trial;
    ASSERT_EQ(one.position, same.position) << "trial " << trial;
  }
}

/// A split by bins is priced by what it divides, for few boxes and for as many as several threads
/// count; and in the bins around it no plane is forgotten: it costs little more than the best.
TEST(CheapestPlane, OfBinsIsNearlyThatOfAll) {
  for (const int count : {40, 100, 200, 400, 800, 1600, 6000}) {
    for (const std::uint64_t seed : {1, 2, 3}) {
      const test::BoxSet set = test::random_boxes(count, seed);
      const TestJob test(set.boxes(), part_of_the_cube, costs);
      const Split split = cheapest_of_bins(test.job, test.parts, test.job.box);
      Split expected = split;
      expected.left = expected.right = 0;
      for (const ObjectPart& part : test.parts) {
        expected.left += part.box.lo[split.axis] <= split.position;
        expected.right += part.box.hi[split.axis] >= split.position;
      }
      ASSERT_EQ(split.left, expected.left) << count;
      ASSERT_EQ(split.right, expected.right) << count;
      expected = with_tests_of_leaves(test.job, test.job.box, expected);
      ASSERT_EQ(split.tests, expected.tests) << count;
      ASSERT_LE(split.tests, 1.01 * find_swept(test).tests) << count;
    }
  }
}

TEST(CheapestPlane, IsLookedForWhereItMayPay) {
  constexpr CostModel free_nodes{.traversal = 0.0, .intersection = 1.5, .empty_factor = 0.9};
  const Aabb cell{Vec3(-1.0f), Vec3(1.0f)};
  const Vec3 half(1.0f, 0.5f, 1.0f);
  for (const Aabb& box : {cell, Aabb{-half, half}, Aabb{cell.lo, half}}) {
    for (const CostModel& model : {costs, free_nodes}) {
      const TestJob test({cell, box}, cell, model);
      const bool is_asked_for = box != cell || model.traversal == 0.0;
      const Split split = find_among_few(test);
      ASSERT_EQ(std::isfinite(split.tests), is_asked_for);
      expect_cheapest_of_few(test, split, "two boxes");
    }
  }
}

TEST(CheapestPlane, IsNotThereWithoutRoom) {
  const std::vector<Aabb> boxes(3, {Vec3(0.0f), Vec3(0x1p-21f)});
  const TestJob test(boxes, boxes[0], costs);
  EXPECT_EQ(find_among_few(test).tests, std::numeric_limits<double>::infinity());
  EXPECT_EQ(find_swept(test).tests, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace bspview
