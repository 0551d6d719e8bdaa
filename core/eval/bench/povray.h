#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/machine.h"
#include "core/base/result.h"
#include "core/base/watch.h"
#include "core/bsp/tree.h"
#include "core/scene/scene.h"

namespace bspview {

struct PovrayParams {
  BuildParams build;  ///< of our trees
  std::string program = "povray";
  int side = 512;  ///< pixels of the pictures, in both directions
  int max_ray_depth = 5;
  int repeats = 9;
};

/// Processor seconds of tracing one picture with one thread, by repeat: shading included, building
/// and parsing not.
struct PictureTimes {
  std::string name;
  std::size_t objects = 0;
  std::vector<double> own;
  std::vector<double> boxes;  ///< POV-Ray, its hierarchy of boxes (+BM1)
  std::vector<double> bsp;    ///< POV-Ray, its BSP tree (+BM2)
};

struct PovrayReport {
  PovrayParams params;
  std::vector<PictureTimes> pictures;
  Machine machine = this_machine();
};

/// Makes the picture of every scene here and by POV-Ray 3.7, in turns. watch.progress adds up to 1.
/// Fails when POV-Ray is not installed or says nothing of its times.
Result<PovrayReport> run_povray(std::span<const Scene> scenes, const PovrayParams& params,
                                const Watch& watch = {});

/// The processor seconds of tracing that POV-Ray's messages tell; nothing when they do not.
std::optional<double> povray_trace_seconds(std::string_view messages);

/// Time of POV-Ray's better bounding over ours: median over the repeats.
double povray_ratio(const PictureTimes& times);

/// Table for the terminal, one object, one line a scene.
std::string to_text(const PovrayReport& report);
std::string to_json(const PovrayReport& report);
std::string to_csv(const PovrayReport& report);

}  // namespace bspview
