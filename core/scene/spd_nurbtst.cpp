// The SPD's test of its tessellator: a cubic B-spline surface over a turned rectangle, as 30 x 25
// cells of two smooth triangles each.

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/scene/spd_generators.h"

namespace bspview {
namespace {

constexpr int rows = 6, columns = 5;       // control points
constexpr int u_cells = 30, v_cells = 25;  // u runs over the rows, v along a row

/// The other two coordinates of the control points lie on a grid of distance 1 around the origin.
constexpr double heights[rows][columns] = {{0, 3, -3, 3, 0}, {0, 0, 0, 0, 0}, {0, 0, 5, 0, 0},
                                           {0, 0, 5, 0, 0},  {0, 0, 0, 0, 0}, {0, -3, 3, -3, 0}};

Vec3d control_point(int row, int column) {
  const double c = std::cos(std::numbers::pi / 6.0), s = 0.5;
  const double x = column - 0.5 * (columns - 1), z = 0.5 * (rows - 1) - row;
  return {c * x + s * z, heights[row][column], c * z - s * x};
}

constexpr int degree = 3;

/// Clamped, evenly spaced knots over [0, 1].
std::vector<double> make_knots(int control_points) {
  const int spans = control_points - degree;
  std::vector<double> knots(degree, 0.0);
  for (int i = 0; i <= spans; ++i) knots.push_back(double(i) / spans);
  knots.insert(knots.end(), degree, 1.0);
  return knots;
}

/// Value at `t` of the B-spline of `order` - 1st degree that starts at knot `i` (Cox & de Boor).
double b_spline(const std::vector<double>& knots, int i, int order, double t) {
  if (order == 1) {
    const bool last_span = knots[i] < 1.0 && knots[i + 1] == 1.0;
    return knots[i] <= t && (t < knots[i + 1] || last_span) ? 1.0 : 0.0;
  }
  const double left = knots[i + order - 1] - knots[i], right = knots[i + order] - knots[i + 1];
  double value = 0.0;
  if (left > 0.0) value += (t - knots[i]) / left * b_spline(knots, i, order - 1, t);
  if (right > 0.0) value += (knots[i + order] - t) / right * b_spline(knots, i + 1, order - 1, t);
  return value;
}

double b_spline_slope(const std::vector<double>& knots, int i, double t) {
  const double left = knots[i + degree] - knots[i], right = knots[i + degree + 1] - knots[i + 1];
  double slope = 0.0;
  if (left > 0.0) slope += degree / left * b_spline(knots, i, degree, t);
  if (right > 0.0) slope -= degree / right * b_spline(knots, i + 1, degree, t);
  return slope;
}

/// How much each control point counts at one parameter, and how that changes along it.
template <int control_points>
struct Weights {
  std::array<double, control_points> value, slope;

  explicit Weights(double t) {
    const std::vector<double> knots = make_knots(control_points);
    for (int i = 0; i < control_points; ++i) {
      value[i] = b_spline(knots, i, degree + 1, t);
      slope[i] = b_spline_slope(knots, i, t);
    }
  }
};

struct SurfacePoint {
  Vec3 position, normal;
};

SurfacePoint surface_point(int u_step, int v_step) {
  const Weights<rows> u(double(u_step) / u_cells);
  const Weights<columns> v(double(v_step) / v_cells);
  Vec3d position(0.0), along_u(0.0), along_v(0.0);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Vec3d point = control_point(row, column);
      position += u.value[row] * v.value[column] * point;
      along_u += u.slope[row] * v.value[column] * point;
      along_v += u.value[row] * v.slope[column] * point;
    }
  }
  return {Vec3(position), Vec3(glm::normalize(glm::cross(along_v, along_u)))};
}

void add_patch(Scene& scene, std::uint32_t material, const std::array<SurfacePoint, 3>& points) {
  add_face(scene, material, std::array{points[0].position, points[1].position, points[2].position},
           std::array{points[0].normal, points[1].normal, points[2].normal});
}

}  // namespace

double count_nurbtst(int) {
  return 2.0 * u_cells * v_cells;
}

void make_nurbtst(Scene& scene, int) {
  scene.background = Vec3(0.0f);
  scene.camera = {.from = {0.0f, 5.0f, -10.0f},
                  .at = Vec3(0.0f),
                  .up = {0.0f, 1.0f, 0.0f},
                  .angle_degrees = 30.0f,
                  .hither = 0.001f,
                  .width = 256,
                  .height = 256};
  scene.lights = {{{0.0f, 50.0f, -10.0f}}};
  const std::uint32_t red =
      add_material(scene, {.color = {1.0f, 0.0f, 0.0f}, .diffuse = 0.7f, .shine = 45.2776f});
  for (int u = 0; u < u_cells; ++u) {
    for (int v = 0; v < v_cells; ++v) {
      const SurfacePoint a = surface_point(u, v), b = surface_point(u + 1, v);
      const SurfacePoint c = surface_point(u + 1, v + 1), d = surface_point(u, v + 1);
      add_patch(scene, red, {a, b, c});
      add_patch(scene, red, {a, c, d});
    }
  }
}

}  // namespace bspview
