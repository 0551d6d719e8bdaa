// Height field y = cos(2 pi r) exp(-r) - 3 over the xz plane, after the SPD's example by Enzmann.

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/scene/spd_generators.h"

namespace bspview {
namespace {

constexpr double half_side = 4.0;

/// Points along a side: 32, twice as many with every size.
int side_points(int size) {
  return 32 << (size - 1);
}

class HeightField {
 public:
  explicit HeightField(int points) : points_(points) {
    vertices_.reserve(std::size_t(points) * points);
    for (int row = 0; row < points; ++row) {
      for (int column = 0; column < points; ++column) vertices_.push_back(sample(column, row));
    }
  }

  Vec3 vertex(int column, int row) const { return vertices_[std::size_t(row) * points_ + column]; }

 private:
  /// The published scene takes its heights at steps of side / points, but spreads them over the
  /// side in points - 1 steps: the hat is off its centre by up to half a cell.
  Vec3 sample(int column, int row) const {
    const double height_step = 2.0 * half_side / points_;
    const double r = std::hypot(column * height_step - half_side, row * height_step - half_side);
    const double height = std::cos(2.0 * std::numbers::pi * r) * std::exp(-r) - 3.0;
    const double step = 2.0 * half_side / (points_ - 1);
    return {column * step - half_side, height, row * step - half_side};
  }

  int points_;
  std::vector<Vec3> vertices_;
};

}  // namespace

double count_sombrero(int size) {
  const double cells = 32.0 * std::pow(2.0, size - 1.0) - 1.0;
  return 2.0 * cells * cells;
}

void make_sombrero(Scene& scene, int size) {
  scene.background = spd_sky;
  scene.camera = {.from = {0.0f, 5.0f, -8.0f},
                  .at = Vec3(0.0f),
                  .up = {0.0f, 0.0f, 1.0f},
                  .angle_degrees = 40.0f,
                  .hither = 0.01f};
  scene.lights = {{{10.0f, 10.0f, -10.0f}}};
  const std::uint32_t material =
      add_material(scene, {.color = {1.0f, 0.1f, 0.1f}, .diffuse = 0.8f, .shine = 2.60078f});
  const int points = side_points(size);
  const HeightField field(points);
  for (int row = 0; row + 1 < points; ++row) {
    for (int column = 0; column + 1 < points; ++column) {
      const Vec3 a = field.vertex(column, row), b = field.vertex(column + 1, row);
      const Vec3 c = field.vertex(column + 1, row + 1), d = field.vertex(column, row + 1);
      add_face(scene, material, std::array{a, c, b});
      add_face(scene, material, std::array{a, d, c});
    }
  }
}

}  // namespace bspview
