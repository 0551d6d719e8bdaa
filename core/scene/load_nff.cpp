// After Haines, "Neutral File Format", version 3.1, in the Standard Procedural Databases 3.14.

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/file.h"
#include "core/scene/default_view.h"
#include "core/scene/load.h"
#include "core/scene/token_reader.h"

namespace bspview {
namespace {

bool read(TokenReader& tokens, Sphere& sphere) {
  return tokens.read_vec3(sphere.centre, "the centre of a sphere") &&
         tokens.read_float(sphere.radius, "the radius of a sphere");
}

bool read(TokenReader& tokens, Cone& cone) {
  return tokens.read_vec3(cone.base, "the base of a cone") &&
         tokens.read_float(cone.base_radius, "the base radius of a cone") &&
         tokens.read_vec3(cone.apex, "the apex of a cone") &&
         tokens.read_float(cone.apex_radius, "the apex radius of a cone");
}

bool read(TokenReader& tokens, Material& fill) {
  return tokens.read_vec3(fill.color, "the colour of a fill") &&
         tokens.read_float(fill.diffuse, "Kd of a fill") &&
         tokens.read_float(fill.specular, "Ks of a fill") &&
         tokens.read_float(fill.shine, "the shine of a fill") &&
         tokens.read_float(fill.transmittance, "T of a fill") &&
         tokens.read_float(fill.refraction_index, "the index of refraction of a fill");
}

bool read(TokenReader& tokens, Light& light) {
  if (!tokens.read_vec3(light.position, "the position of a light")) return false;
  return !tokens.number_follows() || tokens.read_vec3(light.color, "the colour of a light");
}

struct Corners {
  std::vector<Vec3> vertices, normals;
};

/// Makes room for as many vertices, each of `numbers` numbers, as the next token says.
bool read_vertex_count(TokenReader& tokens, std::int64_t numbers, Corners& corners) {
  std::int64_t count = 0;
  if (!tokens.read_count(count, 3, "the number of vertices")) return false;
  // A number takes a space and a digit: so the rest of the file bounds the count.
  const auto most = static_cast<std::int64_t>(tokens.bytes_left()) / (2 * numbers);
  if (count > most) {
    return tokens.fail("the file ends before the last of " + std::to_string(count) + " vertices");
  }
  corners.vertices.resize(static_cast<std::size_t>(count));
  return true;
}

bool read_polygon(TokenReader& tokens, Corners& corners) {
  corners.normals.clear();
  if (!read_vertex_count(tokens, 3, corners)) return false;
  for (Vec3& vertex : corners.vertices)
    if (!tokens.read_vec3(vertex, "a vertex of a polygon")) return false;
  return true;
}

bool read_patch(TokenReader& tokens, Corners& corners) {
  if (!read_vertex_count(tokens, 6, corners)) return false;
  corners.normals.resize(corners.vertices.size());
  for (std::size_t i = 0; i < corners.vertices.size(); ++i) {
    if (!tokens.read_vec3(corners.vertices[i], "a vertex of a patch")) return false;
    if (!tokens.read_vec3(corners.normals[i], "a normal of a patch")) return false;
  }
  return true;
}

bool read_angle(TokenReader& tokens, Camera& camera) {
  if (!tokens.read_float(camera.angle_degrees, "the angle of the view")) return false;
  if (camera.angle_degrees > 0.0f && camera.angle_degrees < 180.0f) return true;
  return tokens.fail_expecting("an angle of the view between 0 and 180 degrees");
}

bool read_side(TokenReader& tokens, int& pixels) {
  constexpr std::int64_t largest = 1 << 16;
  std::int64_t side = 0;
  if (!tokens.read_count(side, 1, "the resolution of the view")) return false;
  if (side > largest)
    return tokens.fail_expecting("a resolution of at most " + std::to_string(largest) + " pixels");
  pixels = static_cast<int>(side);
  return true;
}

struct ViewField {
  std::string_view name;
  bool (*read)(TokenReader&, Camera&);
  bool required;
};

constexpr ViewField view_fields[] = {
    {"from", [](TokenReader& t, Camera& c) { return t.read_vec3(c.from, "the eye point"); }, true},
    {"at", [](TokenReader& t, Camera& c) { return t.read_vec3(c.at, "the point looked at"); },
     true},
    {"up", [](TokenReader& t, Camera& c) { return t.read_vec3(c.up, "the up vector"); }, true},
    {"angle", read_angle, true},
    {"hither", [](TokenReader& t, Camera& c) { return t.read_float(c.hither, "hither"); }, false},
    {"resolution",
     [](TokenReader& t, Camera& c) { return read_side(t, c.width) && read_side(t, c.height); },
     false}};

/// The fields of a `v` record, in any order.
bool read(TokenReader& tokens, Camera& camera) {
  camera = {};
  std::array<bool, std::size(view_fields)> given{};
  for (;;) {
    const std::string_view name = tokens.peek();
    const auto* const field = std::ranges::find(view_fields, name, &ViewField::name);
    if (field == std::end(view_fields)) break;
    tokens.take();
    if (!field->read(tokens, camera)) return false;
    given[static_cast<std::size_t>(field - view_fields)] = true;
  }
  for (std::size_t i = 0; i < given.size(); ++i)
    if (view_fields[i].required && !given[i])
      return tokens.fail("the view has no `" + std::string(view_fields[i].name) + '`');
  if (camera.from == camera.at) return tokens.fail("the view looks at the point it looks from");
  return true;
}

/// Puts the records of one text into one scene.
class NffReader {
 public:
  NffReader(std::string_view text, const std::string& file_name) : tokens_(text, file_name) {
    scene_.name = std::filesystem::path(file_name).stem().string();
  }

  Result<Scene> read_scene() {
    while (!tokens_.peek().empty())
      if (!read_record()) return tokens_.error();
    tokens_.take();
    if (scene_.objects.empty()) {
      tokens_.fail("the file holds no object");
      return tokens_.error();
    }
    if (!has_view_) scene_.camera = make_default_view(scene_bounds(scene_));
    if (scene_.lights.empty()) scene_.lights.push_back(make_default_light(scene_.camera));
    return std::move(scene_);
  }

 private:
  bool read_record() {
    const std::string_view record = tokens_.take();
    if (record == "s" || record == "c" || record == "p" || record == "pp")
      return read_object(record);
    if (record == "f") return read_fill();
    if (record == "l") return read(tokens_, scene_.lights.emplace_back());
    if (record == "b") return tokens_.read_vec3(scene_.background, "the background colour");
    if (record == "v") return has_view_ = read(tokens_, scene_.camera);
    return tokens_.fail_expecting("one of the records v, b, l, f, s, c, p and pp");
  }

  bool read_object(std::string_view record) {
    if (material_ == no_index) use_material({});
    if (record == "s") {
      Sphere sphere;
      if (!read(tokens_, sphere)) return false;
      add_sphere(scene_, material_, sphere);
    } else if (record == "c") {
      Cone cone;
      if (!read(tokens_, cone)) return false;
      add_cone(scene_, material_, cone);
    } else {
      const bool done =
          record == "p" ? read_polygon(tokens_, corners_) : read_patch(tokens_, corners_);
      if (!done) return false;
      add_face(scene_, material_, corners_.vertices, corners_.normals);
    }
    return true;
  }

  bool read_fill() {
    Material fill;
    if (!read(tokens_, fill)) return false;
    use_material(fill);
    return true;
  }

  void use_material(const Material& fill) {
    const MaterialKey key{fill.color.x,  fill.color.y, fill.color.z,       fill.diffuse,
                          fill.specular, fill.shine,   fill.transmittance, fill.refraction_index};
    const auto next = static_cast<std::uint32_t>(scene_.materials.size());
    const auto [place, is_new] = materials_.try_emplace(key, next);
    if (is_new) scene_.materials.push_back(fill);
    material_ = place->second;
  }

  using MaterialKey = std::array<float, 8>;

  TokenReader tokens_;
  Scene scene_;
  std::map<MaterialKey, std::uint32_t> materials_;  // their index in the scene: files repeat them
  std::uint32_t material_ = no_index;               // of the latest `f` record
  bool has_view_ = false;
  Corners corners_;  // of the latest face, to keep its memory
};

}  // namespace

Result<Scene> parse_nff(std::string_view text, const std::string& file_name) {
  return NffReader(text, file_name).read_scene();
}

Result<Scene> load_nff(const std::filesystem::path& file) {
  const Result<std::string> text = read_file(file);
  if (!text) return text.error();
  return parse_nff(*text, file.string());
}

}  // namespace bspview
