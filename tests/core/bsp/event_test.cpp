#include "core/bsp/event.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/bsp/event_list.h"
#include "core/bsp/event_sort.h"
#include "core/math/float_error.h"
#include "tests/support/box_sets.h"
#include "tests/support/random.h"

namespace bspview {
namespace {

constexpr float tiny = std::numeric_limits<float>::denorm_min();
constexpr float largest = std::numeric_limits<float>::max();
constexpr float infinity = std::numeric_limits<float>::infinity();

/// A job without limits over a box set.
struct TestJob {
  explicit TestJob(const test::BoxSet& set, bool clip)
      : input(set.input()), job{.input = input, .clip = clip} {
    for (std::uint32_t i = 0; i < set.size(); ++i) {
      parts.push_back({set.boxes()[i], i});
      job.box.grow(set.boxes()[i]);
    }
  }

  BuildInput input;
  BuildJob job;
  std::vector<ObjectPart> parts;
};

References objects_of(const EventList& list) {
  References objects;
  objects.resize(list.count());
  list.write_objects(objects.data());
  return objects;
}

/// Boxes on a lattice so fine that many bounds are equal and the others are an ulp or two apart.
test::BoxSet boxes_ulps_apart(int count, std::uint64_t seed) {
  test::Random random(seed);
  const float base = random.below(3) == 0 ? 0.0f : random.between(-2.0f, 2.0f);
  const auto bound = [&] {
    float x = base;
    for (int steps = random.below(6); steps > 0; --steps) x = next_up(x);
    return x;
  };
  std::vector<Aabb> boxes(static_cast<std::size_t>(count));
  for (Aabb& box : boxes) {
    box.grow({bound(), bound(), bound()});
    box.grow({bound(), bound(), bound()});
  }
  return test::BoxSet(std::move(boxes));
}

TEST(Event, LiesOneFloatOutsideThePart) {
  for (const float x : {-largest, -1.0f, -tiny, -0.0f, 0.0f, tiny, 1.0f, 1e30f, largest}) {
    EXPECT_EQ(Event::make_start(x, 7).position(), next_down(x)) << std::hexfloat << x;
    EXPECT_EQ(Event::make_end(x, 7).position(), next_up(x)) << std::hexfloat << x;
  }
  EXPECT_EQ(Event::make_end(largest, 0).position(), infinity);
}

TEST(Event, KeepsKindAndPart) {
  const Event start = Event::make_start(2.5f, Event::part_mask);
  EXPECT_TRUE(start.is_start());
  EXPECT_EQ(start.part(), Event::part_mask);
  const Event end = Event::make_end(-2.5f, 3).with_part(12);
  EXPECT_TRUE(end.is_end());
  EXPECT_EQ(end.part(), 12u);
  EXPECT_EQ(end.position(), next_up(-2.5f));
}

TEST(Event, SortsByPositionThenEndsBeforeStartsThenPart) {
  const float below = next_down(next_down(1.0f));  // ends where 1 starts
  EXPECT_LT(Event::make_start(-3.0f, 9), Event::make_start(-2.0f, 1));
  EXPECT_LT(Event::make_end(-2.0f, 9), Event::make_end(3.0f, 1));
  EXPECT_EQ(Event::make_end(below, 0).position(), Event::make_start(1.0f, 0).position());
  EXPECT_LT(Event::make_end(below, 9), Event::make_start(1.0f, 1));
  EXPECT_LT(Event::make_start(1.0f, 1), Event::make_start(1.0f, 2));
  EXPECT_EQ(Event::make_start(0.0f, 1), Event::make_start(-0.0f, 1));
}

TEST(Event, SortsFewAndManyAlike) {
  const BuildInput none;
  const BuildJob job{.input = none};
  for (const std::uint32_t count : {0u, 1u, 50u, 5000u, 100000u}) {
    test::Random random(count);
    std::vector<Event> events;
    for (std::uint32_t part = 0; part < count; ++part) {
      const float lo = 0.25f * static_cast<float>(random.below(40) - 20);
      events.push_back(Event::make_start(lo, part));
      events.push_back(Event::make_end(lo + 0.25f * static_cast<float>(random.below(3)), part));
    }
    std::vector<Event> expected = events;
    std::ranges::sort(expected);
    std::vector<Event> sorted = events;
    sort_events(job, events, sorted.data());
    EXPECT_EQ(sorted, expected) << count;
  }
}

/// A job that is to stop.
struct StoppedJob {
  StoppedJob() { stop.request_stop(); }
  std::stop_source stop;
  BuildInput none;
  BuildJob job{.input = none, .stop = stop.get_token()};
};

TEST(Event, AStopEndsSortingBeforeManyMoreEvents) {
  const StoppedJob stopped;
  std::vector<Event> events;
  for (std::uint32_t part = 0; part < 2000; ++part) events.push_back(Event::make_end(0.0f, part));
  std::vector<Event> sorted = events;
  EXPECT_THROW(sort_events(stopped.job, events, sorted.data()), BuildStopped);
}

TEST(Event, AStopEndsMergingBeforeManyMoreEvents) {
  const StoppedJob stopped;
  std::vector<Event> events(4, Event::make_end(1.0f, 7));
  const std::vector<Event> before = events, fresh(2, Event::make_end(0.0f, 1));
  EXPECT_THROW(merge_events(stopped.job, std::span(events).first(2), fresh), BuildStopped);
  EXPECT_EQ(events, before);
}

TEST(Event, MergesFreshOnesInOrder) {
  const BuildInput none;
  const BuildJob job{.input = none};
  test::Random random(5);
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<Event> events, fresh;
    for (int i = random.below(20); i > 0; --i) {
      events.push_back(Event::make_start(random.between(-1.0f, 1.0f), random.below(9)));
    }
    for (int i = random.below(20); i > 0; --i) {
      fresh.push_back(Event::make_end(random.between(-1.0f, 1.0f), random.below(9)));
    }
    std::ranges::sort(events);
    std::ranges::sort(fresh);
    const std::size_t count = events.size();
    events.insert(events.end(), fresh.begin(), fresh.end());
    std::vector<Event> expected = events;
    std::ranges::sort(expected);
    merge_events(job, std::span(events).first(count), fresh);
    EXPECT_EQ(events, expected);
  }
}

// What the sweep counts is what the split deals out, and both are the closed sides of the plane,
// for planes at, between and beside bounds that are one float apart.
TEST(EventList, CountsAreClassificationsForBoundsOneFloatApart) {
  for (std::uint64_t trial = 0; trial < 10'000; ++trial) {
    const test::BoxSet set = boxes_ulps_apart(2 + static_cast<int>(trial % 7), trial);
    const TestJob test(set, trial % 2 == 0);
    ScratchStack scratch;
    EventList list(test.job, test.parts, scratch);
    const int axis = static_cast<int>(trial % 3);
    const std::span<const Event> events = list.events(axis);
    const float plane = events[trial % events.size()].position();

    Split split{.axis = axis, .position = plane};
    const auto size = static_cast<std::uint32_t>(set.size());
    for (const Event event : events) {
      if (event.is_start()) split.left += event.position() < plane;
      if (event.is_end()) split.right += event.position() > plane;
    }
    References expected_left, expected_right;
    for (std::uint32_t i = 0; i < size; ++i) {
      if (set.boxes()[i].lo[axis] <= plane) expected_left.push_back(i);
      if (set.boxes()[i].hi[axis] >= plane) expected_right.push_back(i);
    }
    const CellSplit cut(split, test.job.box);
    const EventList other = list.split(cut, scratch);
    ASSERT_EQ(split.left, expected_left.size()) << trial;
    ASSERT_EQ(split.right, expected_right.size()) << trial;
    ASSERT_EQ(objects_of(cut.keeps_left() ? list : other), expected_left) << trial;
    ASSERT_EQ(objects_of(cut.keeps_left() ? other : list), expected_right) << trial;
  }
}

TEST(EventList, ASplitListIsTheListOfTheParts) {
  const test::BoxSet set = test::random_boxes(3000, 6);
  const TestJob test(set, true);
  ScratchStack scratch;
  EventList list(test.job, test.parts, scratch);
  Split split{.axis = 1, .position = 0.1f};
  for (const Aabb& box : set.boxes()) {
    split.left += box.lo[1] <= 0.1f;
    split.right += box.hi[1] >= 0.1f;
  }
  const CellSplit cut(split, test.job.box);
  const EventList other = list.split(cut, scratch);
  const auto expect_fresh_list = [&](const EventList& side, const Aabb& cell) {
    std::vector<ObjectPart> parts;
    for (const std::uint32_t object : objects_of(side)) {
      parts.push_back({intersection(set.boxes()[object], cell), object});
    }
    const EventList fresh(test.job, parts, scratch);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_TRUE(std::ranges::equal(side.events(axis), fresh.events(axis)));
    }
  };
  expect_fresh_list(cut.keeps_left() ? list : other, cut.cells.left);
  expect_fresh_list(cut.keeps_left() ? other : list, cut.cells.right);
}

}  // namespace
}  // namespace bspview
