#include "core/eval/bench/povray_scene.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace bspview {
namespace {

std::string vector(Vec3 v) {
  return fmt::format("<{:.9g},{:.9g},{:.9g}>", v.x, v.y, v.z);
}

class PovWriter {
 public:
  explicit PovWriter(const Scene& scene)
      : scene_(scene),
        intensity_(0.5f / std::sqrt(std::max(1.0f, static_cast<float>(scene.lights.size())))) {}

  std::string write(int max_ray_depth) {
    // Nothing is cut off that counts for little: no ray is left out here either.
    text_ = fmt::format(
        "#version 3.7;\nglobal_settings {{ assumed_gamma 1 max_trace_level {} adc_bailout 0 }}\n"
        "background {{ rgb {} }}\n",
        max_ray_depth, vector(scene_.background));
    write_camera(scene_.camera);
    for (const Light& light : scene_.lights) {
      add("light_source {{ {} rgb {} }}\n", vector(light.position),
          vector(intensity_ * light.color));
    }
    for (std::size_t i = 0; i < scene_.materials.size(); ++i) write_material(i);
    for (std::uint32_t id = 0; id < scene_.objects.size(); ++id) {
      if (!is_degenerate(scene_, id)) write_object(scene_.objects[id]);
    }
    end_mesh();
    return std::move(text_);
  }

 private:
  template <class... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
  }

  /// POV-Ray's axes are left-handed: its picture is mirrored by a negative `right`.
  void write_camera(const Camera& camera) {
    const float aspect = static_cast<float>(camera.width) / static_cast<float>(camera.height);
    const float half = std::tan(0.5f * glm::radians(camera.angle_degrees)) * aspect;
    add("camera {{ location {} sky {} right -{:.9g}*x up y angle {:.9g} look_at {} }}\n",
        vector(camera.from), vector(camera.up), aspect, 2.0f * glm::degrees(std::atan(half)),
        vector(camera.at));
  }

  void write_material(std::size_t i) {
    const Material& material = scene_.materials[i];
    add("#declare M{} = material {{ texture {{ pigment {{ rgb {} transmit {:.9g} }}\n", i,
        vector(material.color), material.transmittance);
    add("finish {{ ambient {:.9g} diffuse {:.9g} phong {:.9g} phong_size {:.9g} reflection {:.9g} "
        "}} }}\n",
        intensity_ * material.diffuse, material.diffuse, material.specular, material.shine,
        material.specular);
    add("interior {{ ior {:.9g} }} }}\n",
        material.transmittance > 0.0f ? material.refraction_index : 1.0f);
  }

  void write_object(const Object& object) {
    if (object.kind == ObjectKind::triangle) {
      write_triangle(object);
      return;
    }
    end_mesh();
    if (object.kind == ObjectKind::sphere) {
      const Sphere& sphere = scene_.spheres[object.shape];
      add("sphere {{ {}, {:.9g}", vector(sphere.centre), std::abs(sphere.radius));
    } else if (object.kind == ObjectKind::cone) {
      const Cone& cone = scene_.cones[object.shape];
      add("cone {{ {}, {:.9g}, {}, {:.9g} open", vector(cone.base), std::abs(cone.base_radius),
          vector(cone.apex), std::abs(cone.apex_radius));
    } else {
      write_polygon(scene_.faces[object.shape]);
    }
    add(" material {{ M{} }} }}\n", object.material);
  }

  void write_polygon(const Face& face) {
    add("polygon {{ {}", face.vertex_count + 1);
    const auto vertices = vertices_of(scene_, face);
    for (const Vec3 vertex : vertices) text_ += "," + vector(vertex);
    text_ += "," + vector(vertices.front());
  }

  /// Triangles in a row with one material become a mesh, which POV-Ray traces faster.
  void write_triangle(const Object& object) {
    if (mesh_material_ != object.material) {
      end_mesh();
      text_ += "mesh {\n";
      mesh_material_ = object.material;
    }
    const Face& face = scene_.faces[object.shape];
    const auto vertices = vertices_of(scene_, face);
    const bool smooth = face.first_normal != no_index;
    text_ += smooth ? "smooth_triangle { " : "triangle { ";
    for (std::size_t i = 0; i < 3; ++i) {
      text_ += (i > 0 ? "," : "") + vector(vertices[i]);
      if (smooth) text_ += "," + vector(scene_.normals[face.first_normal + i]);
    }
    text_ += " }\n";
  }

  void end_mesh() {
    if (mesh_material_ != no_index) add("material {{ M{} }} }}\n", mesh_material_);
    mesh_material_ = no_index;
  }

  const Scene& scene_;
  const float intensity_;
  std::uint32_t mesh_material_ = no_index;  // of the mesh that is being written
  std::string text_;
};

}  // namespace

std::string to_povray(const Scene& scene, int max_ray_depth) {
  return PovWriter(scene).write(max_ray_depth);
}

}  // namespace bspview
