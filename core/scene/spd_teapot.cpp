// Newell's teapot: 32 Bezier patches, a bottom among them, on a checkerboard. `size` is the number
// of cells along a patch and along the board; a cell of a patch is cut into two triangles.

#include <array>
#include <cmath>
#include <vector>

#include "core/scene/spd_generators.h"

namespace bspview {
namespace {

using Row = std::array<Vec3d, 4>;
using Patch = std::array<Row, 4>;  // u runs over the rows, v along a row

/// Control points of a surface of revolution around z.
struct Profile {
  struct Point {
    double radius, height;
    double roundness = 0.56;  // length of the handles of Newell's quarter circles, in radii
  };
  std::array<Point, 4> points;
  double turn = -1.0;  // the quarters follow each other clockwise, or (1) counter-clockwise
};

constexpr Profile rim{{{{1.4, 2.4}, {1.3375, 2.53125}, {1.4375, 2.53125}, {1.5, 2.4}}}};
constexpr Profile upper_body{{{{1.5, 2.4}, {1.75, 1.875}, {2.0, 1.35}, {2.0, 0.9}}}};
constexpr Profile lower_body{{{{2.0, 0.9}, {2.0, 0.45}, {1.5, 0.225}, {1.5, 0.15}}}};
constexpr Profile knob{{{{0.0, 3.15}, {0.8, 3.15, 0.5625}, {0.0, 2.85}, {0.2, 2.7}}}};
constexpr Profile lid{{{{0.2, 2.7}, {0.4, 2.55}, {1.3, 2.55}, {1.3, 2.4}}}};
constexpr Profile bottom{{{{0.0, 0.0}, {1.425, 0.0}, {1.5, 0.075}, {1.5, 0.15}}}, 1.0};

/// Control points of a tube around a curve in the plane y = 0, which cuts it into two halves: where
/// the halves meet, and how wide they are.
struct Tube {
  struct Section {
    double inner_x, inner_z, outer_x, outer_z, width;
  };
  std::array<Section, 4> sections;
};

constexpr Tube upper_handle{{{{-1.6, 2.025, -1.5, 2.25, 0.3},
                              {-2.3, 2.025, -2.5, 2.25, 0.3},
                              {-2.7, 2.025, -3.0, 2.25, 0.3},
                              {-2.7, 1.8, -3.0, 1.8, 0.3}}}};
constexpr Tube lower_handle{{{{-2.7, 1.8, -3.0, 1.8, 0.3},
                              {-2.7, 1.575, -3.0, 1.35, 0.3},
                              {-2.5, 1.125, -2.65, 0.9375, 0.3},
                              {-2.0, 0.9, -1.9, 0.6, 0.3}}}};
constexpr Tube lower_spout{{{{1.7, 1.425, 1.7, 0.6, 0.66},
                             {2.6, 1.425, 3.1, 0.825, 0.66},
                             {2.3, 2.1, 2.4, 2.025, 0.25},
                             {2.7, 2.4, 3.3, 2.4, 0.25}}}};
constexpr Tube upper_spout{{{{2.7, 2.4, 3.3, 2.4, 0.25},
                             {2.8, 2.475, 3.525, 2.49375, 0.25},
                             {2.9, 2.475, 3.45, 2.5125, 0.15},
                             {2.8, 2.4, 3.2, 2.4, 0.15}}}};

void append_revolution(std::vector<Patch>& patches, const Profile& profile) {
  Patch patch;
  for (int row = 0; row < 4; ++row) {
    const auto [r, z, roundness] = profile.points[row];
    const double handle = roundness * r, side = profile.turn;
    patch[row] = {Vec3d(r, 0, z), Vec3d(r, side * handle, z), Vec3d(handle, side * r, z),
                  Vec3d(0, side * r, z)};
  }
  for (int quarter = 0; quarter < 4; ++quarter) {
    patches.push_back(patch);
    for (Row& row : patch) {
      for (Vec3d& p : row) p = {-profile.turn * p.y, profile.turn * p.x, p.z};
    }
  }
}

void append_tube(std::vector<Patch>& patches, const Tube& tube) {
  Patch right, left;
  for (int row = 0; row < 4; ++row) {
    const auto [xi, zi, xo, zo, width] = tube.sections[row];
    right[row] = {Vec3d(xi, 0, zi), Vec3d(xi, -width, zi), Vec3d(xo, -width, zo), Vec3d(xo, 0, zo)};
    left[row] = {Vec3d(xo, 0, zo), Vec3d(xo, width, zo), Vec3d(xi, width, zi), Vec3d(xi, 0, zi)};
  }
  patches.push_back(right);
  patches.push_back(left);
}

std::vector<Patch> teapot_patches() {
  std::vector<Patch> patches;
  for (const Profile& profile : {rim, upper_body, lower_body}) append_revolution(patches, profile);
  for (const Tube& tube : {upper_handle, lower_handle, lower_spout, upper_spout}) {
    append_tube(patches, tube);
  }
  for (const Profile& profile : {knob, lid, bottom}) append_revolution(patches, profile);
  return patches;
}

struct Weights {
  std::array<double, 4> value, slope;
};

/// Cubic Bernstein polynomials and their derivatives.
Weights bernstein(double t) {
  const double s = 1.0 - t;
  return {{s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t},
          {-3.0 * s * s, 3.0 * s * s - 6.0 * s * t, 6.0 * s * t - 3.0 * t * t, 3.0 * t * t}};
}

Vec3d blend(const Patch& patch, const std::array<double, 4>& u, const std::array<double, 4>& v) {
  Vec3d sum(0.0);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) sum += u[row] * v[column] * patch[row][column];
  }
  return sum;
}

/// Outward unit normal. Where a whole row is one point (on the axis), v has no direction; the one
/// it has just beside the point takes its place.
Vec3d patch_normal(const Patch& patch, const Weights& u, const Weights& v) {
  const Vec3d along_u = blend(patch, u.slope, v.value);
  const Vec3d along_v = blend(patch, u.value, v.slope);
  constexpr double no_length = 1e-9;  // far above rounding, far below every other derivative
  const bool on_axis = glm::length(along_v) < no_length;
  const Vec3d across = on_axis ? blend(patch, u.slope, v.slope) : along_v;
  return glm::normalize(glm::cross(across, along_u));
}

/// One patch sampled at (size + 1)^2 points.
class PatchGrid {
 public:
  PatchGrid(const Patch& patch, int size) : stride_(size + 1) {
    for (int i = 0; i <= size; ++i) {
      const Weights u = bernstein(double(i) / size);
      for (int j = 0; j <= size; ++j) {
        const Weights v = bernstein(double(j) / size);
        vertices_.emplace_back(blend(patch, u.value, v.value));
        normals_.emplace_back(patch_normal(patch, u, v));
      }
    }
  }

  /// Adds the triangle of three points, each its row and column.
  void add_triangle(Scene& scene, std::uint32_t material,
                    const std::array<glm::ivec2, 3>& points) const {
    std::array<Vec3, 3> vertices, normals;
    for (int i = 0; i < 3; ++i) {
      const std::size_t index = std::size_t(points[i].x) * stride_ + points[i].y;
      vertices[i] = vertices_[index];
      normals[i] = normals_[index];
    }
    add_face(scene, material, vertices, normals);
  }

 private:
  int stride_;
  std::vector<Vec3> vertices_, normals_;
};

void add_patch(Scene& scene, std::uint32_t material, const Patch& patch, int size) {
  const PatchGrid grid(patch, size);
  const bool starts_in_one_point = patch[0].front() == patch[0].back();
  for (int u = 0; u < size; ++u) {
    for (int v = 0; v < size; ++v) {
      const glm::ivec2 a(u, v), b(u, v + 1), c(u + 1, v + 1), d(u + 1, v);
      const bool degenerate = starts_in_one_point && u == 0;
      if (!degenerate) grid.add_triangle(scene, material, {a, b, c});
      grid.add_triangle(scene, material, {c, d, a});
    }
  }
}

/// The squares of one colour: those whose column and row add up to an odd number (1) or even (0).
void add_squares(Scene& scene, Vec3 color, int parity, int size) {
  const std::uint32_t material = add_material(scene, {.color = color,
                                                      .diffuse = 0.5f,
                                                      .specular = 0.5f,
                                                      .shine = 4.81884f,
                                                      .refraction_index = 0.0f});
  const auto edge = [&](int i) { return 8.0 * i / size - 4.0; };
  for (int column = 0; column < size; ++column) {
    for (int row = (column + parity) % 2; row < size; row += 2) {
      const double left = edge(column), right = edge(column + 1);
      const double near = edge(row), far = edge(row + 1);
      add_face(scene, material,
               std::array{Vec3(left, near, 0.0), Vec3(right, near, 0.0), Vec3(right, far, 0.0),
                          Vec3(left, far, 0.0)});
    }
  }
}

}  // namespace

double count_teapot(int size) {
  return 65.0 * size * size - 8.0 * size;
}

void make_teapot(Scene& scene, int size) {
  scene.two_sided = true;  // the lid leaves a gap
  scene.background = spd_sky;
  scene.camera = {.from = {4.86f, 7.2f, 5.4f},
                  .at = Vec3(0.0f),
                  .up = {0.0f, 0.0f, 1.0f},
                  .angle_degrees = 45.0f,
                  .hither = 1.0f};
  scene.lights = {{{-3.1f, 9.8f, 12.1f}}, {{11.3f, 5.1f, 8.8f}}};
  add_squares(scene, Vec3(1.0f), 1, size);
  add_squares(scene, Vec3(0.5f), 0, size);
  const std::uint32_t pot = add_material(scene, {.color = {1.0f, 0.5f, 0.1f},
                                                 .diffuse = 0.75f,
                                                 .specular = 0.25f,
                                                 .shine = 3.0827f,
                                                 .refraction_index = 0.0f});
  for (const Patch& patch : teapot_patches()) add_patch(scene, pot, patch, size);
}

}  // namespace bspview
