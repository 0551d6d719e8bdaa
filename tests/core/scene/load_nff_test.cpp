#include <gtest/gtest.h>

#include <random>

#include "core/scene/load.h"

namespace bspview {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view one_of_each = R"(# a scene with every record
b 0.1 0.2 0.3
v
from 1 2 3
at 0 0 0.5
up 0 0 1
angle 30
hither 0.01
resolution 640 480
l 4 3 2
l 1 -4 4 0.5 0.25 1   # a coloured light
f 1 0.75 0.33 0.8 0.1 100 0.2 1.5
s 0 0 0 0.5
c 0 0 0 1
  0 0 2 0.5
p 4
1 1 0  -1 1 0  -1 -1 0  1 -1 0
f 0 1 0 1 0 0 0 1
pp 3
0 0 0 0 0 1
1 0 0 0 0 1
0 1 0 0 0 1
s 1 1 1 -0.25
p 3 0 0 0 1 0 0 0 1 0
)";

Result<Scene> parse(std::string_view text) {
  return parse_nff(text, "a.nff");
}

std::string error_of(std::string_view text) {
  const Result<Scene> scene = parse(text);
  return scene ? "no error" : scene.error().message;
}

void expect_error_or_scene(const std::string& text) {
  const Result<Scene> scene = parse(text);
  if (scene) {
    EXPECT_GT(scene->objects.size(), 0u) << text;
  } else {
    EXPECT_TRUE(scene.error().message.starts_with("a.nff:")) << text;
  }
}

TEST(LoadNff, ReadsOneOfEachRecord) {
  const Result<Scene> scene = parse(one_of_each);
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_EQ(scene->name, "a");
  EXPECT_EQ(scene->background, Vec3(0.1f, 0.2f, 0.3f));
  const Camera camera{{1, 2, 3}, {0, 0, 0.5f}, {0, 0, 1}, 30.0f, 0.01f, 640, 480};
  EXPECT_EQ(scene->camera, camera);
  const std::vector<Light> lights = {{{4, 3, 2}, Vec3(1)}, {{1, -4, 4}, {0.5f, 0.25f, 1}}};
  EXPECT_EQ(scene->lights, lights);
  const Material red{{1, 0.75f, 0.33f}, 0.8f, 0.1f, 100, 0.2f, 1.5f};
  EXPECT_EQ(scene->materials, (std::vector{red, Material{{0, 1, 0}, 1, 0, 0, 0, 1}}));
  EXPECT_EQ(count_objects(*scene), (ObjectCounts{6, 1, 1, 1, 2, 1}));
  EXPECT_EQ(scene->spheres[1], (Sphere{{1, 1, 1}, -0.25f}));
  EXPECT_EQ(scene->cones[0], (Cone{{0, 0, 0}, 1, {0, 0, 2}, 0.5f}));
  EXPECT_EQ(scene->vertices[2], Vec3(-1, -1, 0));
  EXPECT_EQ(scene->normals.size(), 3u);
  EXPECT_EQ(scene->faces[1].first_normal, 0u);
  EXPECT_EQ(scene->objects[3], (Object{ObjectKind::triangle, 1, 1}));
  EXPECT_EQ(scene->objects[5], (Object{ObjectKind::triangle, 2, 1}));
  EXPECT_FALSE(scene->two_sided);
}

TEST(LoadNff, TheLayoutOfTheTextPlaysNoPart) {
  const Result<Scene> scene = parse(one_of_each);
  std::string bare;  // without the comments
  for (bool comment = false; const char c : one_of_each) {
    comment = c == '#' || (comment && c != '\n');
    if (!comment) bare += c;
  }
  std::string dense, carriage, commented = "\xEF\xBB\xBF";
  for (const char c : bare) {
    dense += c == '\n' ? ' ' : c;
    carriage += c == '\n' ? "\r\n" : std::string(1, c);
    commented += c == ' ' ? " # 1 2 s\n" : std::string(1, c);
  }
  for (const std::string& text : {dense, carriage, commented}) {
    const Result<Scene> other = parse(text);
    ASSERT_TRUE(other.ok()) << other.error().message;
    EXPECT_EQ(*other, *scene);
  }
}

TEST(LoadNff, FieldsOfTheViewComeInAnyOrderAndSomeMayLack) {
  const Result<Scene> scene = parse("v angle 20 up 0 1 0 at 0 0 0 from 0 0 9 s 0 0 0 1");
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_EQ(scene->camera.from, Vec3(0, 0, 9));
  EXPECT_EQ(scene->camera.angle_degrees, 20.0f);
  EXPECT_EQ(scene->camera.width, 512);
}

TEST(LoadNff, AMissingViewIsInventedSoThatTheSceneIsInThePicture) {
  const Result<Scene> scene = parse("s 100 100 100 5 s 110 100 100 5");
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  const PrimaryRays rays(scene->camera, 512, 512);
  for (const Vec3 point : {Vec3(95, 100, 100), Vec3(115, 100, 100), Vec3(100, 100, 105)}) {
    const Vec3 pixel = rays.project(point);
    EXPECT_GT(pixel.z, 0.0f);
    EXPECT_TRUE(pixel.x > 0 && pixel.x < 512 && pixel.y > 0 && pixel.y < 512);
  }
}

TEST(LoadNff, AMissingLightIsInventedAboveTheEye) {
  const Result<Scene> scene = parse("v from 0 -8 0 at 0 0 0 up 0 0 1 angle 45 s 0 0 0 1");
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  ASSERT_EQ(scene->lights.size(), 1u);
  EXPECT_EQ(scene->lights[0].position, Vec3(-2, -8, 4));
}

TEST(LoadNff, ObjectsBeforeTheFirstFillAreWhite) {
  const Result<Scene> scene = parse("s 0 0 0 1 f 1 0 0 1 0 0 0 1 s 1 0 0 1");
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_EQ(scene->materials[scene->objects[0].material], Material{});
  EXPECT_EQ(scene->materials[scene->objects[1].material].color, Vec3(1, 0, 0));
}

TEST(LoadNff, ARepeatedFillIsOneMaterial) {
  std::string text;
  for (int i = 0; i < 3000; ++i)
    text += "f 0." + std::to_string(i % 1000 + 1000) + " 0 0 1 0 0 0 1 s 0 0 0 1\n";
  const Result<Scene> scene = parse(text);
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_EQ(scene->materials.size(), 1000u);
}

TEST(LoadNff, DegenerateObjectsKeepTheirPlace) {
  const Result<Scene> scene = parse("s 0 0 0 0 c 0 0 0 1 0 0 0 1 p 3 0 0 0 0 0 0 0 0 0 s 0 0 0 1");
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_EQ(scene->objects.size(), 4u);
  EXPECT_TRUE(is_degenerate(*scene, 2));
  EXPECT_FALSE(is_degenerate(*scene, 3));
}

TEST(LoadNff, EveryErrorNamesFileLineAndWhatIsWrong) {
  const std::pair<std::string_view, std::string_view> cases[] = {
      {"", "a.nff:1: the file holds no object"},
      {"# nothing\n\n", "a.nff:3: the file holds no object"},
      {"b 0 0 0\nl 1 1 1", "a.nff:2: the file holds no object"},
      {"\nq 1", "a.nff:2: expected one of the records v, b, l, f, s, c, p and pp, found `q`"},
      {"s 0 0 0 1\n1",
       "a.nff:2: expected one of the records v, b, l, f, s, c, p and pp, found `1`"},
      {"s 0 0 0", "a.nff:1: expected the radius of a sphere, found the end of the file"},
      {"s 0 0 0\n\ns 1", "a.nff:3: expected the radius of a sphere, found `s`"},
      {"s 0 0 0 nan", "a.nff:1: expected the radius of a sphere, found `nan`"},
      {"s 0 inf 0 1", "a.nff:1: expected the centre of a sphere, found `inf`"},
      {"s 0 1e40 0 1", "a.nff:1: expected the centre of a sphere, found `1e40`"},
      {"c 0 0 0 1 1 1 1\n",
       "a.nff:2: expected the apex radius of a cone, found the end of the file"},
      {"p 2\n0 0 0 1 1 1", "a.nff:1: expected the number of vertices, at least 3, found `2`"},
      {"p -4", "a.nff:1: expected the number of vertices, at least 3, found `-4`"},
      {"p 3.5", "a.nff:1: expected the number of vertices, found `3.5`"},
      {"p 4\n0 0 0\n", "a.nff:1: the file ends before the last of 4 vertices"},
      {"pp 4000000000\n0 0 0\n", "a.nff:1: the file ends before the last of 4000000000 vertices"},
      {"p 9223372036854775807 0 0 0",
       "a.nff:1: the file ends before the last of 9223372036854775807 vertices"},
      {"p 9999999999999999999 0 0 0",
       "a.nff:1: expected the number of vertices, found `9999999999999999999`"},
      {"p 3 0 0 0 0 0 0 0 0 x", "a.nff:1: expected a vertex of a polygon, found `x`"},
      {"f 1 0 0 1 0 0 0\ns 0 0 0 1",
       "a.nff:2: expected the index of refraction of a fill, found `s`"},
      {"l 1 1 1 1\ns 0 0 0 1", "a.nff:2: expected the colour of a light, found `s`"},
      {"v s 0 0 0 1", "a.nff:1: the view has no `from`"},
      {"v from 0 0 0 at 1 0 0 up 0 0 1 s 0 0 0 1", "a.nff:1: the view has no `angle`"},
      {"v from 1 1 1 at 1 1 1 up 0 0 1 angle 45",
       "a.nff:1: the view looks at the point it looks from"},
      {"v angle 180",
       "a.nff:1: expected an angle of the view between 0 and 180 degrees, found `180`"},
      {"v resolution 0 5", "a.nff:1: expected the resolution of the view, at least 1, found `0`"},
      {"v resolution 9 99999",
       "a.nff:1: expected a resolution of at most 65536 pixels, found `99999`"},
  };
  for (const auto& [text, message] : cases) EXPECT_EQ(error_of(text), message) << text;
}

TEST(LoadNff, ATextCutAnywhereIsAnErrorOrAScene) {
  for (std::size_t size = 0; size <= one_of_each.size(); ++size) {
    // A copy of that size, so that reading past its end is seen by the address sanitizer.
    const std::string text(one_of_each.substr(0, size));
    expect_error_or_scene(text);
  }
}

TEST(LoadNff, ABrokenTokenAnywhereIsAnError) {
  std::size_t broken = 0;
  for (std::size_t i = 0; i < one_of_each.size(); ++i) {
    const std::string_view rest = one_of_each.substr(i);
    const bool starts_token = !std::isspace(rest[0]) && i > 0 && std::isspace(one_of_each[i - 1]);
    const std::size_t line = one_of_each.rfind('\n', i) + 1;
    if (!starts_token || one_of_each.substr(line, i - line + 1).find('#') != one_of_each.npos)
      continue;
    const std::string text = std::string(one_of_each.substr(0, i)) + "?" + std::string(rest);
    EXPECT_FALSE(parse(text).ok()) << "before byte " << i;
    ++broken;
  }
  EXPECT_GT(broken, 100u);
}

TEST(LoadNff, RandomBytesAreAnErrorOrAScene) {
  std::mt19937 random(3);
  const std::string_view alphabet = "vblfscp# \n\r\t0123456789.-+e\0\xff"sv;
  for (int trial = 0; trial < 20000; ++trial) {
    std::string text(random() % 60, ' ');
    for (char& c : text)
      c = trial % 2 ? alphabet[random() % alphabet.size()] : static_cast<char>(random());
    expect_error_or_scene(text);
  }
}

TEST(LoadNff, ChangedBytesAreAnErrorOrAScene) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 20000; ++trial) {
    std::string text(one_of_each);
    for (int i = 0; i < 3; ++i) text[random() % text.size()] = " \n9-.s#e"[random() % 8];
    expect_error_or_scene(text);
  }
}

TEST(LoadNff, APolygonHasAnyNumberOfVertices) {
  constexpr int count = 200000;
  std::string text = "p " + std::to_string(count);
  for (int i = 0; i < count; ++i) text += " " + std::to_string(i) + " 1 0";
  const Result<Scene> scene = parse(text);
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_EQ(scene->faces[0].vertex_count, std::uint32_t{count});
  EXPECT_EQ(scene->vertices.back(), Vec3(count - 1, 1, 0));
}

}  // namespace
}  // namespace bspview
