#include "core/bsp/object_groups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <vector>

#include "tests/support/random.h"

namespace bspview {
namespace {

using test::Random;

struct Member {
  Aabb box;
  bool is_eighth;
};

std::vector<Member> random_members(int count, float share_of_eighths, Random& random) {
  std::vector<Member> members;
  for (int i = 0; i < count; ++i) {
    const Aabb box = random.box(0.1f);
    members.push_back({box, random.between(0.0f, 1.0f) < share_of_eighths});
  }
  return members;
}

/// Groups whose ids are indices into `members`.
ObjectGroups::Range fill(ObjectGroups& groups, const std::vector<Member>& members) {
  groups.clear();
  for (std::size_t i = 0; i < members.size(); ++i) {
    groups.add(static_cast<std::uint32_t>(i), members[i].box, members[i].is_eighth);
  }
  return groups.sort();
}

std::vector<Member> members_of(const ObjectGroups& groups, ObjectGroups::Range range,
                               const std::vector<Member>& members) {
  std::vector<Member> some;
  for (std::size_t i = range.first; i < range.last; ++i) some.push_back(members[groups.id(i)]);
  return some;
}

/// Of a ray that meets the box of some members and tests them all.
double cost_of(std::span<const Member> members) {
  Aabb box;
  double eighths = 0.0;
  for (const Member& member : members) {
    box.grow(member.box);
    eighths += member.is_eighth ? 1.0 : 8.0 * ObjectTests::lone_cost;
  }
  return half_area(box) * std::ceil(eighths / 8.0);
}

/// Of the cheapest way to deal members out to two groups by the middles of their boxes.
double least_cost(std::vector<Member> members) {
  double least = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    std::ranges::stable_sort(members, {}, [&](const Member& m) { return m.box.centre()[axis]; });
    for (std::size_t i = 1; i < members.size(); ++i) {
      const std::span all(members);
      least = std::min(least, cost_of(all.first(i)) + cost_of(all.subspan(i)));
    }
  }
  return least;
}

/// The whole and what it is split into, down to the last groups.
std::vector<ObjectGroups::Range> all_groups(ObjectGroups& groups, ObjectGroups::Range whole,
                                            const auto& look) {
  std::vector<ObjectGroups::Range> last, open{whole};
  while (!open.empty()) {
    const ObjectGroups::Range group = open.back();
    open.pop_back();
    const auto place = groups.split(group);
    look(group, place);
    if (!place) {
      last.push_back(group);
      continue;
    }
    open.push_back({group.first, *place});
    open.push_back({*place, group.last});
  }
  return last;
}

TEST(ObjectGroups, AreSplitWhereItIsCheapestAndOnlyIfItPays) {
  Random random(1);
  for (const float share_of_eighths : {0.0f, 0.7f, 1.0f}) {
    const auto members = random_members(100, share_of_eighths, random);
    ObjectGroups groups(1.0f);
    int splits = 0, whole = 0;
    all_groups(groups, fill(groups, members), [&](ObjectGroups::Range group, auto place) {
      const auto some = members_of(groups, group, members);
      const double area = half_area(groups.box(group)), least = least_cost(some);
      const double worth = cost_of(some) - ObjectGroups::box_cost * area;
      if (!place) {
        EXPECT_GE(least, worth - 1e-5 * area);
        ++whole;
        return;
      }
      const double cost = cost_of(members_of(groups, {group.first, *place}, members)) +
                          cost_of(members_of(groups, {*place, group.last}, members));
      EXPECT_LT(cost, worth + 1e-5 * area);
      EXPECT_NEAR(cost, least, 1e-5 * area);
      ++splits;
    });
    EXPECT_GT(splits, 5);
    EXPECT_GT(whole, 5);
  }
}

TEST(ObjectGroups, HoldEveryObjectOnceInTheBoxOfItsGroup) {
  Random random(2);
  for (const std::size_t count : {std::size_t{1}, std::size_t{2}, ObjectGroups::most_objects}) {
    const auto members = random_members(static_cast<int>(count), 0.9f, random);
    ObjectGroups groups(1.0f);
    const ObjectGroups::Range all = fill(groups, members);
    std::set<std::uint32_t> seen;
    for (const auto group : all_groups(groups, all, [](auto, auto) {})) {
      Aabb box;
      for (std::size_t i = group.first; i < group.last; ++i) {
        EXPECT_TRUE(seen.insert(groups.id(i)).second);
        box.grow(members[groups.id(i)].box);
      }
      EXPECT_EQ(groups.box(group), box);
    }
    EXPECT_EQ(seen.size(), count);
  }
}

TEST(ObjectGroups, OfNothingOrOneThingStayWhole) {
  Random random(4);
  ObjectGroups groups(1.0f);
  EXPECT_FALSE(groups.split(fill(groups, {})));
  EXPECT_FALSE(groups.split(fill(groups, random_members(1, 0.0f, random))));
}

TEST(ObjectGroups, OfEightAtOnceOrOfAlikesStayWhole) {
  Random random(3);
  ObjectGroups groups(1.0f);
  EXPECT_FALSE(groups.split(fill(groups, random_members(8, 1.0f, random))));
  const std::vector<Member> alike(100, {{Vec3(0.0f), Vec3(1.0f)}, false});
  EXPECT_FALSE(groups.split(fill(groups, alike)));
}

std::size_t count_groups(const std::vector<Member>& members) {
  Aabb whole;
  for (const Member& member : members) whole.grow(member.box);
  ObjectGroups groups(area_unit(whole));
  return all_groups(groups, fill(groups, members), [](auto, auto) {}).size();
}

TEST(ObjectGroups, AreTheSameInAnyUnitOfLength) {
  Random random(5);
  const auto members = random_members(300, 0.8f, random);
  const std::size_t count = count_groups(members);
  EXPECT_GT(count, 10u);
  for (const int exponent : {-100, -30, 30, 100}) {
    std::vector<Member> scaled = members;
    const float factor = std::ldexp(1.0f, exponent);
    for (Member& member : scaled) member.box = {factor * member.box.lo, factor * member.box.hi};
    EXPECT_EQ(count_groups(scaled), count);
  }
}

TEST(ObjectGroups, OfPointsHoldThemAll) {
  std::vector<Member> points;
  for (int i = 0; i < 200; ++i) {
    const Vec3 point(static_cast<float>(i), 0.0f, 0.0f);
    points.push_back({{point, point}, i % 2 == 0});
  }
  ObjectGroups groups(1.0f);
  std::size_t found = 0;
  for (const auto group : all_groups(groups, fill(groups, points), [](auto, auto) {})) {
    found += group.size();
  }
  EXPECT_EQ(found, 200u);
}

}  // namespace
}  // namespace bspview
