#pragma once

#include <string>

#include "core/eval/bench/run.h"

namespace bspview {

/// Tables for the terminal; ends with verdict().
std::string to_text(const BenchReport& report);

/// One line a scene, kind of rays and peer.
std::string to_csv(const BenchReport& report);

/// Everything, as one object.
std::string to_json(const BenchReport& report);

/// Bars of the mean ratios with a mark for every scene: a picture that needs nothing else.
std::string to_svg(const BenchReport& report);

/// What to do, in one sentence of figures.
std::string verdict(const BenchReport& report);

}  // namespace bspview
