#include "core/scene/spd.h"

#include <gtest/gtest.h>

#include <climits>
#include <cmath>

#include "tests/support/golden_spd.h"

namespace bspview {
namespace {

struct Golden {
  const char* name;
  const char* file;
  std::size_t objects;
  /// Beside the six printed digits; of the scene's size. nurbtst's program stops just short of the
  /// end of its surface.
  double noise = 1e-7;
};

constexpr Golden goldens[] = {
    {"balls", "balls", 7382},       {"gears", "gears", 9345},   {"jacks", "jacks-3", 657},
    {"lattice", "lattice", 8281},   {"mount", "mount", 8196},   {"nurbtst", "nurbtst", 1500, 2e-6},
    {"rings", "rings", 8401},       {"sample", "sample", 881},  {"shells", "shells", 5761},
    {"sombrero", "sombrero", 1922}, {"teapot", "teapot", 9264}, {"tetra", "tetra", 4096},
    {"tree", "tree", 8191},
};

/// The reference is printed with six significant digits.
constexpr double printed_precision = 6e-6;

void append(std::vector<float>& numbers, Vec3 v) {
  numbers.insert(numbers.end(), {v.x, v.y, v.z});
}

/// Everything that is known of an object's place and shape.
std::vector<float> shape_of(const Scene& scene, const Object& object) {
  std::vector<float> numbers;
  if (object.kind == ObjectKind::sphere) {
    const Sphere& sphere = scene.spheres[object.shape];
    append(numbers, sphere.centre);
    numbers.push_back(sphere.radius);
  } else if (object.kind == ObjectKind::cone) {
    const Cone& cone = scene.cones[object.shape];
    append(numbers, cone.base);
    append(numbers, cone.apex);
    numbers.insert(numbers.end(), {cone.base_radius, cone.apex_radius});
  } else {
    for (Vec3 vertex : vertices_of(scene, scene.faces[object.shape])) append(numbers, vertex);
  }
  return numbers;
}

std::vector<float> normals_of(const Scene& scene, const Object& object) {
  std::vector<float> numbers;
  const bool is_face = object.kind == ObjectKind::triangle || object.kind == ObjectKind::polygon;
  if (!is_face) return numbers;
  const Face& face = scene.faces[object.shape];
  if (face.first_normal == no_index) return numbers;
  for (std::uint32_t i = 0; i < face.vertex_count; ++i) {
    append(numbers, scene.normals[face.first_normal + i]);
  }
  return numbers;
}

std::vector<float> numbers_of(const Material& m) {
  std::vector<float> numbers{m.diffuse, m.specular, m.shine, m.transmittance, m.refraction_index};
  append(numbers, m.color);
  return numbers;
}

/// Background, view and lights.
std::vector<float> surroundings(const Scene& scene) {
  const Camera& camera = scene.camera;
  std::vector<float> numbers{camera.angle_degrees, camera.hither, float(camera.width),
                             float(camera.height)};
  for (Vec3 v : {scene.background, camera.from, camera.at, camera.up}) append(numbers, v);
  for (const Light& light : scene.lights) {
    append(numbers, light.position);
    append(numbers, light.color);
  }
  return numbers;
}

/// Whether all numbers are the expected ones as far as six digits and `slack` tell.
::testing::AssertionResult near(const std::vector<float>& got, const std::vector<float>& expected,
                                double slack) {
  if (got.size() != expected.size()) {
    return ::testing::AssertionFailure() << got.size() << " numbers, not " << expected.size();
  }
  for (std::size_t i = 0; i < got.size(); ++i) {
    const double tolerance = printed_precision * std::abs(expected[i]) + slack;
    if (std::abs(double(got[i]) - expected[i]) <= tolerance) continue;
    return ::testing::AssertionFailure() << "number " << i << " is " << std::hexfloat << got[i]
                                         << ", not " << expected[i] << " +- " << tolerance;
  }
  return ::testing::AssertionSuccess();
}

Scene make(const char* name, std::optional<int> size = std::nullopt) {
  Result<Scene> scene = make_spd(name, size);
  if (!scene) ADD_FAILURE() << scene.error().message;
  return scene ? *std::move(scene) : Scene{};
}

class SpdGolden : public ::testing::TestWithParam<Golden> {
 protected:
  void SetUp() override {
    auto loaded = test::load_golden_spd(GetParam().file);
    ASSERT_TRUE(loaded) << loaded.error().message;
    expected = *std::move(loaded);
    got = make(GetParam().name);
    ASSERT_EQ(got.objects.size(), expected.objects.size());
    slack = GetParam().noise * largest_component(scene_bounds(expected).extent());
  }

  Scene expected, got;
  double slack = 0.0;  // in units of the scene
};

TEST_P(SpdGolden, HasTheObjectsOfTheReferenceInItsOrder) {
  EXPECT_EQ(got.objects.size(), GetParam().objects);
  for (std::size_t i = 0; i < got.objects.size(); ++i) {
    ASSERT_EQ(got.objects[i].kind, expected.objects[i].kind) << "object " << i;
    ASSERT_TRUE(near(shape_of(got, got.objects[i]), shape_of(expected, expected.objects[i]), slack))
        << "object " << i;
  }
}

TEST_P(SpdGolden, HasTheNormalsOfTheReference) {
  constexpr double degenerate_slack = 5e-6;  // of a unit vector
  for (std::size_t i = 0; i < got.objects.size(); ++i) {
    ASSERT_TRUE(near(normals_of(got, got.objects[i]), normals_of(expected, expected.objects[i]),
                     degenerate_slack))
        << "object " << i;
  }
}

TEST_P(SpdGolden, HasTheMaterialsOfTheReference) {
  for (std::size_t i = 0; i < got.objects.size(); ++i) {
    ASSERT_TRUE(near(numbers_of(got.materials[got.objects[i].material]),
                     numbers_of(expected.materials[expected.objects[i].material]), 0.0))
        << "object " << i;
  }
}

TEST_P(SpdGolden, HasTheSurroundingsOfTheReference) {
  EXPECT_TRUE(near(surroundings(got), surroundings(expected), slack));
}

INSTANTIATE_TEST_SUITE_P(Scenes, SpdGolden, ::testing::ValuesIn(goldens),
                         [](const auto& test) { return test.param.name; });

TEST(Spd, ListsThirteenScenesByNameWithTheirStandardSizes) {
  ASSERT_EQ(spd_scenes().size(), std::size(goldens));
  for (std::size_t i = 0; i < std::size(goldens); ++i) {
    const SpdScene& scene = spd_scenes()[i];
    EXPECT_EQ(scene.name, goldens[i].name);
    EXPECT_EQ(*count_spd_objects(scene.name, scene.standard_size), goldens[i].objects);
  }
}

TEST(Spd, CountsWhatItMakes) {
  for (const SpdScene& scene : spd_scenes()) {
    for (int size = 1; size <= 7; ++size) {
      const double count = *count_spd_objects(scene.name, size);
      if (count > 1e5) continue;
      const Scene made = make(scene.name.data(), size);
      EXPECT_EQ(made.objects.size(), count) << scene.name << ":" << size;
    }
  }
}

TEST(Spd, GrowsWithItsSize) {
  for (const SpdScene& scene : spd_scenes()) {
    const double smaller = *count_spd_objects(scene.name, 2),
                 larger = *count_spd_objects(scene.name, 3);
    EXPECT_EQ(larger > smaller, scene.has_size) << scene.name;
    EXPECT_GE(larger, smaller) << scene.name;
  }
}

TEST(Spd, MakesNoDegenerateObjectFromSizeTwoOn) {
  for (const SpdScene& scene : spd_scenes()) {
    for (int size : {2, 3}) {
      const Scene made = make(scene.name.data(), size);
      for (std::uint32_t i = 0; i < made.objects.size(); ++i) {
        ASSERT_FALSE(is_degenerate(made, i)) << made.name << " object " << i;
      }
    }
  }
}

TEST(Spd, NamesTheSceneAsAUserDoes) {
  EXPECT_EQ(make("balls").name, "spd:balls:4");
  EXPECT_EQ(make("tetra", 2).name, "spd:tetra:2");
  EXPECT_EQ(make("sample").name, "spd:sample");
  EXPECT_EQ(make("nurbtst", 9).name, "spd:nurbtst");
}

TEST(Spd, OnlyTheTeapotIsTwoSided) {
  for (const SpdScene& scene : spd_scenes()) {
    EXPECT_EQ(make(scene.name.data(), 1).two_sided, scene.name == "teapot") << scene.name;
  }
}

TEST(Spd, KeepsOneMaterialForEveryLook) {
  EXPECT_LE(make("gears", 9).materials.size(), 1u + 2u * 343u);  // 7^3 shades, of glass or not
  EXPECT_EQ(make("lattice", 20).materials.size(), 4u);
  EXPECT_EQ(make("rings", 9).materials.size(), 7u);
}

TEST(Spd, AFinerMountainKeepsTheHeightsOfACoarserOne) {
  const auto highest = [](const Scene& scene, float x, float y) {
    float height = -INFINITY;
    for (Vec3 vertex : scene.vertices) {
      if (vertex.x == x && vertex.y == y) height = vertex.z;
    }
    return height;
  };
  const Scene coarse = make("mount", 3), fine = make("mount", 5);
  for (Vec3 vertex : coarse.vertices) EXPECT_EQ(highest(fine, vertex.x, vertex.y), vertex.z);
}

TEST(Spd, RefusesAnUnknownNameAndListsTheKnownOnes) {
  const auto scene = make_spd("bunny");
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().message,
            "there is no standard scene \"bunny\"; there are balls, gears, jacks, lattice, mount, "
            "nurbtst, rings, sample, shells, sombrero, teapot, tetra, tree");
  EXPECT_FALSE(count_spd_objects("", 1));
  EXPECT_FALSE(make_spd("Balls"));
}

TEST(Spd, RefusesASizeBelowOne) {
  for (const SpdScene& scene : spd_scenes()) {
    EXPECT_FALSE(make_spd(scene.name, 0)) << scene.name;
    EXPECT_FALSE(make_spd(scene.name, INT_MIN)) << scene.name;
    EXPECT_FALSE(count_spd_objects(scene.name, -3)) << scene.name;
  }
  EXPECT_EQ(make_spd("balls", -3).error().message,
            "spd:balls: size factor -3 is not valid; the smallest is 1");
}

TEST(Spd, RefusesAnAbsurdSizeWithItsNumberOfObjects) {
  EXPECT_EQ(make_spd("tetra", 13).error().message,
            "spd:tetra: size factor 13 would make 67108864 objects; the limit is 20000000");
  EXPECT_EQ(make_spd("balls", 50).error().message,
            "spd:balls: size factor 50 would make 5.8e+47 objects; the limit is 20000000");
  for (const SpdScene& scene : spd_scenes()) {
    EXPECT_EQ(make_spd(scene.name, INT_MAX).ok(), !scene.has_size) << scene.name;
  }
}

}  // namespace
}  // namespace bspview
