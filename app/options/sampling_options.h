#pragma once

#include <CLI/CLI.hpp>
#include <optional>

namespace bspview {

/// How many rays a picture is made of. See RenderParams.
struct SamplingOptions {
  std::optional<int> samples;  ///< a pixel; nothing: not asked for
  float adaptive = 0.0f, cutoff = 0.0f;
};

/// --spp, whose default is told as `default_samples`, --adaptive and --cutoff. `options` outlives
/// the parsing.
void add_sampling_options(CLI::App& app, SamplingOptions& options, int default_samples);

}  // namespace bspview
