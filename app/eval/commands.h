#pragma once

#include "app/eval/command.h"

namespace bspview {

/// Each adds its sub-command to `app`; `run` is set when the user chose it.
void add_stats(CLI::App& app, Run& run);
void add_render(CLI::App& app, Run& run);
void add_cast(CLI::App& app, Run& run);
void add_spd(CLI::App& app, Run& run);
void add_bench(CLI::App& app, Run& run);
void add_stress(CLI::App& app, Run& run);
void add_error(CLI::App& app, Run& run);
void add_tune(CLI::App& app, Run& run);

}  // namespace bspview
