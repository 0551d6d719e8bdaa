// Fractal mountain by midpoint displacement after Carpenter (Fournier, Fussell & Carpenter,
// "Computer rendering of stochastic models", CACM 25(6), 1982), on a square grid, and a pyramid of
// four glass balls.

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/scene/spd_generators.h"

namespace bspview {
namespace {

constexpr double fractal_dimension = 2.2;
constexpr std::uint32_t mountain_number = 21;

/// Linear congruential generator after Press et al., "Numerical Recipes", table of quick
/// generators.
class Random {
 public:
  explicit Random(std::uint32_t seed) : state_(seed % modulus) {}

  /// In [-1, 1).
  double next() {
    state_ = (state_ * 8121 + 28411) % modulus;
    return 2.0 * state_ / modulus - 1.0;
  }

 private:
  static constexpr std::uint32_t modulus = 134456;
  std::uint32_t state_;
};

/// Normal deviate that belongs to `seed`, by Marsaglia's polar method.
double gauss(std::uint32_t seed) {
  Random random(seed);
  for (;;) {
    const double x = random.next(), y = random.next();
    const double r = x * x + y * y;
    if (r > 0.0 && r < 1.0) return x * std::sqrt(-2.0 * std::log(r) / r);
  }
}

/// Heights above the square grid of 2^size cells along x and y.
class Terrain {
 public:
  explicit Terrain(int size)
      : size_(size), cells_(1 << size), heights_(std::size_t(cells_ + 1) * (cells_ + 1)) {
    for (int width = cells_; width > 1; width /= 2) displace_midpoints(width);
  }

  int cells() const { return cells_; }

  Vec3 vertex(int x, int y) const {
    const double cell = 2.0 / cells_;
    return {x * cell - 1.0, y * cell - 1.0, heights_[index(x, y)]};
  }

 private:
  std::size_t index(int x, int y) const { return std::size_t(y) * (cells_ + 1) + x; }
  double height(int x, int y) const { return heights_[index(x, y)]; }

  /// Sets the heights in the middle of the squares of side `width` and of their edges.
  void displace_midpoints(int width) {
    const int half = width / 2;
    const double ratio = std::pow(2.0, 1.0 - 1.0 / (fractal_dimension - 1.0));
    const double rise = half * (2.0 / cells_) * std::sqrt(ratio * ratio - 1.0);
    for (int y = 0; y <= cells_; y += half) {
      const bool y_is_new = y % width != 0;
      for (int x = y_is_new ? 0 : half; x <= cells_; x += y_is_new ? half : width) {
        const bool x_is_new = x % width != 0;
        const int dx = x_is_new ? half : 0, dy = y_is_new ? half : 0;
        const double mean = 0.25 * (height(x - dx, y - dy) + height(x + dx, y - dy) +
                                    height(x - dx, y + dy) + height(x + dx, y + dy));
        const double scale = x_is_new && y_is_new ? std::numbers::sqrt2 * rise : rise;
        heights_[index(x, y)] = mean + scale * gauss(seed(x, y));
      }
    }
  }

  /// The published hash of a grid point, patterns and all. Finer grids give the points they share
  /// with coarser ones the same seed.
  std::uint32_t seed(int x, int y) const {
    const auto bits = [&](int coordinate, int position) {
      const std::uint64_t scaled = std::uint64_t(coordinate) << 32 >> size_;
      return std::uint32_t(scaled << position >> 32);
    };
    return mountain_number + ((bits(x, 23) + bits(y, 15) + bits(x, 7)) & 0xffff);
  }

  int size_, cells_;
  std::vector<double> heights_;
};

void add_glass_balls(Scene& scene) {
  const std::uint32_t glass = add_material(scene, {.color = Vec3(1.0f),
                                                   .diffuse = 0.1f,
                                                   .specular = 0.1f,
                                                   .shine = 101.148f,
                                                   .transmittance = 0.9f,
                                                   .refraction_index = 1.5f});
  const Vec3d centre(-0.8, 0.8, 1.0);
  const double radius = 0.17;
  const double reach = std::sqrt(1.5) * radius;  // from the centre of four touching balls
  const auto add_ball = [&](Vec3d offset) {
    add_sphere(scene, glass, {Vec3(centre + offset), static_cast<float>(radius)});
  };
  add_ball({0.0, 0.0, reach});
  for (int i = 0; i < 3; ++i) {
    const double azimuth = std::numbers::pi * (2.0 / 3.0 * i - 0.25);
    const double across = std::sqrt(8.0) / 3.0 * reach;
    add_ball({across * std::cos(azimuth), across * std::sin(azimuth), -reach / 3.0});
  }
}

/// Cells [x, x + width) x [y, y + width).
struct Square {
  int x, y, width;
};

/// Adds the triangles of `square`, quarter by quarter.
void add_terrain(Scene& scene, std::uint32_t material, const Terrain& terrain, Square square) {
  const auto [x, y, width] = square;
  if (width == 1) {
    const Vec3 a = terrain.vertex(x, y), b = terrain.vertex(x + 1, y);
    const Vec3 c = terrain.vertex(x + 1, y + 1), d = terrain.vertex(x, y + 1);
    add_face(scene, material, std::array{a, b, c});
    add_face(scene, material, std::array{c, d, a});
    return;
  }
  const int half = width / 2;
  add_terrain(scene, material, terrain, {x, y, half});
  add_terrain(scene, material, terrain, {x + half, y, half});
  add_terrain(scene, material, terrain, {x + half, y + half, half});
  add_terrain(scene, material, terrain, {x, y + half, half});
}

}  // namespace

double count_mount(int size) {
  return 2.0 * std::pow(4.0, size) + 4.0;
}

void make_mount(Scene& scene, int size) {
  scene.background = spd_sky;
  scene.camera = {.from = {-1.6f, 1.6f, 1.7f},
                  .at = Vec3(0.0f),
                  .up = {0.0f, 0.0f, 1.0f},
                  .angle_degrees = 45.0f,
                  .hither = 0.01f};
  scene.lights = {{{-100.0f, -100.0f, 100.0f}}};
  add_glass_balls(scene);
  const std::uint32_t rock = add_material(
      scene, {.color = {0.5f, 0.45f, 0.35f}, .shine = no_highlight, .refraction_index = 0.0f});
  const Terrain terrain(size);
  add_terrain(scene, rock, terrain, {0, 0, terrain.cells()});
}

}  // namespace bspview
