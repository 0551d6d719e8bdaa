#include "tests/support/box_sets.h"

#include <limits>

#include "tests/support/random.h"

namespace bspview::test {
namespace {

Aabb around(Vec3 centre, Vec3 half) {
  return {centre - half, centre + half};
}

template <class MakeBox>
BoxSet make_set(int count, MakeBox make_box) {
  std::vector<Aabb> boxes;
  for (int i = 0; i < count; ++i) boxes.push_back(make_box(i));
  return BoxSet(std::move(boxes));
}

Vec3 on_axis(int axis, float value) {
  Vec3 v(0.0f);
  v[axis] = value;
  return v;
}

}  // namespace

BoxSet random_boxes(int count, std::uint64_t seed) {
  Random random(seed);
  return make_set(count, [&](int) {
    const Vec3 centre = random.point(1.0f);
    return around(centre, glm::abs(random.point(0.02f)));
  });
}

std::vector<HardCase> hard_cases(int count, std::uint64_t seed) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  constexpr float largest = std::numeric_limits<float>::max();
  Random random(seed);
  std::vector<HardCase> cases;
  const auto add = [&](const std::string& name, auto make_box) {
    cases.push_back({name, make_set(count, make_box)});
  };
  const auto part = [&](int i) { return static_cast<float>(i + 1) / static_cast<float>(count); };

  add("identical", [&](int) { return around(Vec3(1.0f), Vec3(0.5f)); });
  add("one point", [&](int) { return around(Vec3(1.0f), Vec3(0.0f)); });
  add("points at the origin", [&](int) { return around(Vec3(0.0f), Vec3(0.0f)); });
  add("concentric", [&](int i) { return around(Vec3(0.0f), Vec3(part(i))); });
  add("collinear points", [&](int i) { return around(Vec3(part(i)), Vec3(0.0f)); });
  add("collinear on one axis", [&](int i) { return around(on_axis(1, part(i)), Vec3(0.0f)); });
  add("needles",
      [&](int i) { return around(random.point(1.0f), Vec3(1e-6f) + on_axis(i % 3, 1.0f)); });
  for (int axis = 0; axis < 3; ++axis) {
    const std::string on = " on axis " + std::to_string(axis);
    add("flat" + on,
        [&](int) { return around(random.point(1.0f), Vec3(0.1f) - on_axis(axis, 0.1f)); });
    add("in one plane" + on, [&](int) {
      const Vec3 point = random.point(1.0f);
      return around(point + on_axis(axis, 3.0f - point[axis]), Vec3(0.1f) - on_axis(axis, 0.1f));
    });
  }
  add("touching in a grid", [&](int i) {
    return around(Vec3(static_cast<float>(i % 10), static_cast<float>(i / 10 % 10),
                       static_cast<float>(i / 100)),
                  Vec3(0.5f));
  });
  add("huge", [&](int) { return around(random.point(1e38f), Vec3(1e37f)); });
  add("the whole range", [&](int) { return Aabb{Vec3(-largest), random.point(largest)}; });
  add("far away", [&](int) { return around(Vec3(1e6f) + random.point(1.0f), Vec3(0.01f)); });
  add("denormal", [&](int) { return around(random.point(1e-40f), Vec3(1e-42f)); });
  add("unusable in between", [&](int i) {
    if (i % 4 == 1) return Aabb{};
    if (i % 4 == 2) return Aabb{Vec3(-infinity), Vec3(infinity)};
    if (i % 4 == 3) return around(Vec3(std::numeric_limits<float>::quiet_NaN()), Vec3(1.0f));
    return around(random.point(1.0f), Vec3(0.05f));
  });
  return cases;
}

}  // namespace bspview::test
