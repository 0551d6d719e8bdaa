#pragma once

#include <cstdint>

#include "core/math/vec.h"
#include "core/scene/scene.h"
#include "core/scene/spd.h"

namespace bspview {

/// One row of the table in spd.cpp: a scene of the SPD with what makes it.
///
/// `make` fills everything but the name; the scene it is given is empty. `size` is at least 1 and
/// small enough for max_spd_objects. Coordinates are computed in double and rounded once.
struct SpdGenerator {
  SpdScene scene;
  double (*count)(int size);
  void (*make)(Scene& scene, int size);
};

double count_balls(int size);
double count_gears(int size);
double count_jacks(int size);
double count_lattice(int size);
double count_mount(int size);
double count_nurbtst(int size);
double count_rings(int size);
double count_sample(int size);
double count_shells(int size);
double count_sombrero(int size);
double count_teapot(int size);
double count_tetra(int size);
double count_tree(int size);

void make_balls(Scene& scene, int size);
void make_gears(Scene& scene, int size);
void make_jacks(Scene& scene, int size);
void make_lattice(Scene& scene, int size);
void make_mount(Scene& scene, int size);
void make_nurbtst(Scene& scene, int size);
void make_rings(Scene& scene, int size);
void make_sample(Scene& scene, int size);
void make_shells(Scene& scene, int size);
void make_sombrero(Scene& scene, int size);
void make_teapot(Scene& scene, int size);
void make_tetra(Scene& scene, int size);
void make_tree(Scene& scene, int size);

/// The sky of most scenes.
inline constexpr Vec3 spd_sky{0.078f, 0.361f, 0.753f};

/// Phong exponent that the SPD gives to a surface without highlight.
inline constexpr float no_highlight = 100000.0f;

/// Adds the square of side 2 `half` at height `z` around the z axis, its front upwards.
void add_ground(Scene& scene, std::uint32_t material, float half, float z);

}  // namespace bspview
