#include "core/eval/stress/mesh.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace bspview::stress {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;  // radians

/// Vertices that faces share: moved and rounded once, so that neighbours have the same ones.
class MeshMaker {
 public:
  explicit MeshMaker(Vec3 centre) : centre_(centre) { mesh_.centre = centre; }

  int add_vertex(Vec3d place) {
    vertices_.push_back(Vec3(Vec3d(centre_) + place));
    return static_cast<int>(vertices_.size()) - 1;
  }
  void add(std::initializer_list<int> corners) {
    std::vector<Vec3> face;
    for (const int corner : corners) face.push_back(vertices_[static_cast<std::size_t>(corner)]);
    add_face(mesh_.scene, 0, face);
  }
  ClosedMesh finish(const char* name, float ring = 0.0f) {
    mesh_.scene.name = name;
    mesh_.scene.materials.resize(1);
    mesh_.ring = ring;
    return std::move(mesh_);
  }

 private:
  Vec3 centre_;
  std::vector<Vec3> vertices_;
  ClosedMesh mesh_;
};

using Triangle = std::array<int, 3>;

/// Subdivides the triangles of a sphere once; `places` are the vertices.
std::vector<Triangle> subdivide(const std::vector<Triangle>& triangles,
                                std::vector<Vec3d>& places) {
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), 0);
    if (is_new) {
      at->second = static_cast<int>(places.size());
      places.push_back(glm::normalize(places[static_cast<std::size_t>(a)] +
                                      places[static_cast<std::size_t>(b)]));
    }
    return at->second;
  };
  std::vector<Triangle> finer;
  for (const auto& [a, b, c] : triangles) {
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  return finer;
}

/// Calls pole(i, j) for each triangle at a pole and square(a, b, c, d) for the others.
template <class Square>
void add_globe(MeshMaker& maker, int rows, int columns, const Square& square) {
  const int north = maker.add_vertex({0, 0, 1}), south = maker.add_vertex({0, 0, -1});
  std::vector<int> ring_starts;
  for (int row = 1; row < rows; ++row) {
    const double latitude = 0.5 * turn * row / rows;
    for (int column = 0; column < columns; ++column) {
      const double longitude = turn * column / columns;
      const int vertex =
          maker.add_vertex({std::sin(latitude) * std::cos(longitude),
                            std::sin(latitude) * std::sin(longitude), std::cos(latitude)});
      if (column == 0) ring_starts.push_back(vertex);
    }
  }
  const auto at = [&](std::size_t ring, int column) {
    return ring_starts[ring] + column % columns;
  };
  const std::size_t last = ring_starts.size() - 1;
  for (int column = 0; column < columns; ++column) {
    maker.add({north, at(0, column), at(0, column + 1)});
    maker.add({south, at(last, column + 1), at(last, column)});
    for (std::size_t ring = 0; ring < last; ++ring) {
      square(at(ring, column), at(ring + 1, column), at(ring + 1, column + 1),
             at(ring, column + 1));
    }
  }
}

}  // namespace

Vec3 ClosedMesh::point_inside(Dice& dice) const {
  if (ring == 0.0f) return centre + 0.4f * dice.unit() * dice.direction();
  const double angle = turn * dice.unit();
  return Vec3(Vec3d(centre) + double{ring} * Vec3d(std::cos(angle), std::sin(angle), 0.0)) +
         dice.point(0.08f);
}

ClosedMesh make_icosphere(int levels, Vec3 centre) {
  const double golden = std::numbers::phi;
  std::vector<Vec3d> places;
  for (int axis = 0; axis < 3; ++axis) {
    for (int corner = 0; corner < 4; ++corner) {
      Vec3d place(0.0);
      place[(axis + 1) % 3] = corner & 1 ? 1.0 : -1.0;
      place[(axis + 2) % 3] = corner & 2 ? golden : -golden;
      places.push_back(glm::normalize(place));
    }
  }
  // Its faces: three vertices at the shortest distance of each other.
  const double edge = 2.0 / std::sqrt(1.0 + golden * golden);
  const auto adjacent = [&](int a, int b) {
    const Vec3d way = places[static_cast<std::size_t>(a)] - places[static_cast<std::size_t>(b)];
    return glm::length(way) < 1.1 * edge;
  };
  std::vector<Triangle> triangles;
  for (int a = 0; a < 12; ++a) {
    for (int b = a + 1; b < 12; ++b) {
      for (int c = b + 1; c < 12; ++c) {
        if (adjacent(a, b) && adjacent(b, c) && adjacent(c, a)) triangles.push_back({a, b, c});
      }
    }
  }
  for (int level = 0; level < levels; ++level) triangles = subdivide(triangles, places);
  MeshMaker maker(centre);
  for (const Vec3d& place : places) maker.add_vertex(place);
  for (const auto& [a, b, c] : triangles) maker.add({a, b, c});
  return maker.finish("icosphere");
}

ClosedMesh make_torus(int n, Vec3 centre) {
  constexpr float ring = 1.0f, tube = 0.4f;
  MeshMaker maker(centre);
  for (int i = 0; i < n * n; ++i) {
    const double around = turn * (i / n) / n, across = turn * (i % n) / n;
    const double radius = ring + tube * std::cos(across);
    maker.add_vertex(
        {radius * std::cos(around), radius * std::sin(around), tube * std::sin(across)});
  }
  const auto at = [n](int i, int j) { return i % n * n + j % n; };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      maker.add({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      maker.add({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return maker.finish("torus", ring);
}

ClosedMesh make_cube(int n, Vec3 centre) {
  MeshMaker maker(centre);
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const auto corner = [&](int i, int j) {
      Vec3d place(0.0);
      place[axis] = side % 2 == 0 ? -1.0 : 1.0;
      place[(axis + 1) % 3] = -1.0 + 2.0 * i / n;
      place[(axis + 2) % 3] = -1.0 + 2.0 * j / n;
      return maker.add_vertex(place);
    };
    for (int i = 0; i < n * n; ++i) {
      const int u = i / n, v = i % n;
      const int a = corner(u, v), c = corner(u + 1, v + 1);
      maker.add({a, corner(u + 1, v), c});
      maker.add({a, c, corner(u, v + 1)});
    }
  }
  return maker.finish("cube");
}

ClosedMesh make_globe(int rows, int columns, Vec3 centre) {
  MeshMaker maker(centre);
  add_globe(maker, rows, columns, [&](int a, int b, int c, int d) {
    maker.add({a, b, c});
    maker.add({a, c, d});
  });
  return maker.finish("globe");
}

ClosedMesh make_square_globe(int rows, int columns, Vec3 centre) {
  MeshMaker maker(centre);
  add_globe(maker, rows, columns, [&](int a, int b, int c, int d) { maker.add({a, b, c, d}); });
  return maker.finish("square globe");
}

Vec3 aim_at(const Scene& scene, const Aabb& box, Aim aim, Dice& dice) {
  if (aim == Aim::anywhere || scene.faces.empty()) {
    const Vec3 share{dice.unit(), dice.unit(), dice.unit()};
    return glm::clamp(box.lo + share * box.extent(), box.lo, box.hi);
  }
  const auto face = static_cast<std::size_t>(dice.below(static_cast<int>(scene.faces.size())));
  const auto vertices = vertices_of(scene, scene.faces[face]);
  const auto corner = static_cast<std::size_t>(dice.below(static_cast<int>(vertices.size())));
  const Vec3d a(vertices[corner]), b(vertices[(corner + 1) % vertices.size()]);
  const double share = aim == Aim::edge ? dice.unit() : 0.0;
  return Vec3(a + share * (b - a));
}

Ray ray_through(const ClosedMesh& mesh, Aim aim, Dice& dice) {
  const Vec3 inside = mesh.point_inside(dice);
  if (aim == Aim::anywhere) return {inside, dice.direction()};
  const Vec3 target = aim_at(mesh.scene, {}, aim, dice);
  if (dice.one_in(2)) return {inside, target - inside};
  // From beyond the target: far enough that a rounded direction still leads through the inside.
  const Vec3 origin = target + dice.between(1.0f, 3.0f) * (target - inside);
  return {origin, target - origin};
}

}  // namespace bspview::stress
