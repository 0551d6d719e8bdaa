#include <charconv>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/file.h"
#include "core/scene/load.h"

namespace bspview {
namespace {

constexpr int exact_digits = 9;  // so many keep every float

/// Makes the text of one scene.
class NffWriter {
 public:
  explicit NffWriter(int digits) : digits_(digits) {}

  void write(const Scene& scene) {
    line("b", scene.background);
    write_view(scene.camera);
    for (const Light& light : scene.lights) write_light(light);
    std::uint32_t material = no_index;
    for (const Object& object : scene.objects) {
      if (object.material != material) write_fill(scene.materials[object.material]);
      material = object.material;
      write_object(scene, object);
    }
  }

  std::string take_text() { return std::move(text_); }

 private:
  /// One line of words with a space between them.
  template <class... Words>
  void line(const Words&... words) {
    (word(words), ...);
    text_.back() = '\n';
  }

  void word(std::string_view text) {
    text_ += text;
    text_ += ' ';
  }

  void word(int count) { word(std::to_string(count)); }
  void word(std::uint32_t count) { word(std::to_string(count)); }

  void word(Vec3 v) {
    word(v.x);
    word(v.y);
    word(v.z);
  }

  void word(float x) {
    char buffer[64];
    char* const end = std::end(buffer);
    const auto written = digits_ < exact_digits
                             ? std::to_chars(buffer, end, x, std::chars_format::general, digits_)
                             : std::to_chars(buffer, end, x);
    word(std::string_view(buffer, written.ptr));
  }

  void write_view(const Camera& camera) {
    line("v");
    line("from", camera.from);
    line("at", camera.at);
    line("up", camera.up);
    line("angle", camera.angle_degrees);
    line("hither", camera.hither);
    line("resolution", camera.width, camera.height);
  }

  void write_light(const Light& light) {
    if (light.color == Vec3(1.0f)) {
      line("l", light.position);
    } else {
      line("l", light.position, light.color);
    }
  }

  void write_fill(const Material& fill) {
    line("f", fill.color, fill.diffuse, fill.specular, fill.shine, fill.transmittance,
         fill.refraction_index);
  }

  void write_object(const Scene& scene, const Object& object) {
    switch (object.kind) {
      case ObjectKind::triangle:
      case ObjectKind::polygon:
        return write_face(scene, scene.faces[object.shape]);
      case ObjectKind::sphere:
        return write_sphere(scene.spheres[object.shape]);
      case ObjectKind::cone:
        return write_cone(scene.cones[object.shape]);
    }
  }

  void write_sphere(const Sphere& sphere) { line("s", sphere.centre, sphere.radius); }

  void write_cone(const Cone& cone) {
    line("c", cone.base, cone.base_radius, cone.apex, cone.apex_radius);
  }

  void write_face(const Scene& scene, const Face& face) {
    const bool patch = face.first_normal != no_index;
    line(patch ? "pp" : "p", face.vertex_count);
    for (std::uint32_t i = 0; i < face.vertex_count; ++i) {
      const Vec3 vertex = scene.vertices[face.first_vertex + i];
      if (patch) {
        line(vertex, scene.normals[face.first_normal + i]);
      } else {
        line(vertex);
      }
    }
  }

  int digits_;
  std::string text_;
};

}  // namespace

std::string format_nff(const Scene& scene, int digits) {
  NffWriter writer(digits);
  writer.write(scene);
  return writer.take_text();
}

Result<void> save_nff(const Scene& scene, const std::filesystem::path& file, int digits) {
  return write_file(file, format_nff(scene, digits));
}

}  // namespace bspview
