#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace bspview {

/// Opens what the user named: `spd:NAME[:SIZE]` or a file, its format chosen by its extension.
Result<Scene> load_scene(const std::string& source);

/// Reads NFF (Haines, "Neutral File Format"): tokens, not lines. Errors name file and line. A file
/// without an object is an error; what else it lacks is invented (core/scene/default_view.h; white
/// fills), so that there is something to see.
Result<Scene> load_nff(const std::filesystem::path& file);
Result<Scene> parse_nff(std::string_view text, const std::string& file_name);

/// Writes `scene` as NFF, numbers with at most `digits` significant digits (6 is what the SPD's own
/// programs print; 9 keeps every float, written as short as that allows).
Result<void> save_nff(const Scene& scene, const std::filesystem::path& file, int digits = 9);
std::string format_nff(const Scene& scene, int digits = 9);

}  // namespace bspview
