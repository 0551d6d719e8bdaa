#include "tests/architecture/include_rules.h"

#include <algorithm>
#include <regex>

namespace bspview::test {
namespace {

/// A folder of ours. It may include itself and what has a lower rank, but not another of its rank.
struct Layer {
  std::string_view folder;
  int rank;
};

constexpr Layer layers[] = {
    {"core/base/", 0}, {"core/math/", 1},           {"core/shape/", 2}, {"core/scene/", 3},
    {"core/bsp/", 3},  {"core/render/", 4},         {"core/eval/", 5},  {"app/options/", 6},
    {"app/eval/", 8},  {"app/viewer/overlays/", 7}, {"app/viewer/", 8}, {"tests/support/", 9},
    {"tests/", 10},
};

/// A library that only some files know, by the start of their path.
struct Library {
  std::string_view name;
  std::vector<std::string_view> headers;  // starts of what is included
  std::vector<std::string_view> users;
};

// The window, with or without a display, is the files window and offscreen; the interface in it is
// interface with its fonts, theme, keys (actions) and input_queue; gl/screen draws both.
const Library libraries[] = {
    {"Dear ImGui",
     {"imgui", "backends/imgui"},
     {"app/viewer/panels/", "app/viewer/app.", "app/viewer/window.", "app/viewer/offscreen.",
      "app/viewer/interface.", "app/viewer/fonts.", "app/viewer/theme.", "app/viewer/actions.",
      "app/viewer/input_queue.", "app/viewer/gl/screen."}},
    {"GLFW", {"GLFW/", "backends/imgui_impl_glfw"}, {"app/viewer/window."}},
    {"OpenGL",
     {"GL/", "GLES", "EGL/", "KHR/", "epoxy/", "backends/imgui_impl_opengl"},
     {"app/viewer/gl/", "app/viewer/window.", "app/viewer/offscreen."}},
};

const Layer* find_layer(std::string_view path) {
  const auto* const layer = std::ranges::find_if(
      layers, [&](const Layer& candidate) { return path.starts_with(candidate.folder); });
  return layer == std::end(layers) ? nullptr : layer;
}

bool starts_with_any(std::string_view path, const std::vector<std::string_view>& starts) {
  return std::ranges::any_of(starts,
                             [&](std::string_view start) { return path.starts_with(start); });
}

bool arrow_runs_back(const Layer& from, const Layer& to) {
  return to.rank > from.rank || (to.rank == from.rank && to.folder != from.folder);
}

}  // namespace

std::optional<std::string> find_broken_rule(std::string_view file, std::string_view included) {
  const Layer* const from = find_layer(file);
  const Layer* const to = find_layer(included);
  if (!from) return "is in no folder of the architecture";
  const std::string arrow = "includes " + std::string(included) + ": ";
  if (to && arrow_runs_back(*from, *to))
    return arrow + std::string(from->folder) + " does not know " + std::string(to->folder);
  if (file.starts_with("tests/")) return std::nullopt;
  for (const Library& library : libraries)
    if (starts_with_any(included, library.headers) && !starts_with_any(file, library.users))
      return arrow + std::string(library.name) + " is not known here";
  return std::nullopt;
}

std::vector<std::string> includes_of(std::string_view text) {
  static const std::regex include(R"(^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"])",
                                  std::regex::ECMAScript | std::regex::multiline);
  std::vector<std::string> included;
  for (std::cregex_iterator match(text.data(), text.data() + text.size(), include), end;
       match != end; ++match)
    included.push_back((*match)[1]);
  return included;
}

}  // namespace bspview::test
