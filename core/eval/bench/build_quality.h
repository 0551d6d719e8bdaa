#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/eval/bench/build_run.h"

namespace bspview {

/// What rays make of the trees of every builder: a table, and the same as a list of scenes.
std::string quality_table(const BuildReport& report);
nlohmann::ordered_json quality_json(const BuildReport& report);

}  // namespace bspview
