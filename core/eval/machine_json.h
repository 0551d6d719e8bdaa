#pragma once

#include <nlohmann/json.hpp>

#include "core/base/machine.h"

namespace bspview {

/// The key `machine` of every report.
inline nlohmann::ordered_json machine_json(const Machine& machine) {
  return {{"cpu", machine.cpu},
          {"cores", machine.cores},
          {"simd", machine.simd},
          {"compiler", machine.compiler},
          {"version", machine.version}};
}

}  // namespace bspview
