#pragma once

#include <filesystem>

#include "app/viewer/state.h"

namespace bspview {

/// What is kept from one run of the viewer to the next.
struct Settings {
  int window_width = 1280, window_height = 800;
  Look look;
  BoxView boxes;
  bool path_visible = true;
  bool measure_times = true;
  int samples = 4;  ///< a pixel
  bool operator==(const Settings&) const = default;
};

/// bspview/settings.json in $XDG_CONFIG_HOME or else in ~/.config; empty when there is neither.
std::filesystem::path settings_file();

/// What the file says; the standard for whatever it lacks, or when it cannot be read.
Settings load_settings(const std::filesystem::path& file);

/// Makes the folder as well. The error is no reason to bother anyone: a home may be read-only.
Result<void> save_settings(const Settings& settings, const std::filesystem::path& file);

void apply_settings(const Settings& settings, State& state);
Settings settings_of(const State& state, int window_width, int window_height);

}  // namespace bspview
