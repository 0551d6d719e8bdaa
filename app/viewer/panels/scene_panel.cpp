#include "app/viewer/panels/scene_panel.h"

#include <fmt/format.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "app/viewer/panels/numbers.h"
#include "app/viewer/panels/scopes.h"
#include "app/viewer/panels/widgets.h"
#include "core/scene/spd.h"

namespace bspview {
namespace {

constexpr std::string_view spd_prefix = "spd:";

/// A standard scene as the user names it.
struct SpdChoice {
  int index = -1;  ///< into spd_scenes()
  int size = 0;
};

SpdChoice spd_choice(const std::string& source) {
  if (!source.starts_with(spd_prefix)) return {};
  const std::string rest = source.substr(spd_prefix.size());
  const std::size_t colon = rest.find(':');
  const auto scenes = spd_scenes();
  const auto found =
      std::ranges::find(scenes, std::string_view(rest).substr(0, colon), &SpdScene::name);
  if (found == scenes.end()) return {};
  SpdChoice choice{static_cast<int>(found - scenes.begin()), found->standard_size};
  if (colon != std::string::npos) choice.size = std::max(1, std::atoi(rest.c_str() + colon + 1));
  return choice;
}

std::string source_of(const SpdChoice& choice) {
  const SpdScene& scene = spd_scenes()[static_cast<std::size_t>(choice.index)];
  if (!scene.has_size || choice.size == scene.standard_size)
    return fmt::format("{}{}", spd_prefix, scene.name);
  return fmt::format("{}{}:{}", spd_prefix, scene.name, choice.size);
}

void source_field(const Ui& ui, State& state) {
  ImGui::SetNextItemWidth(-1.0f);
  if (state.focus_source) ImGui::SetKeyboardFocusHere();
  state.focus_source = false;
  if (ImGui::InputTextWithHint(
          "##source", "file, or spd:NAME:SIZE", &state.source_text,
          ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll))
    open_source(state, state.source_text);
  ui.note("scene.source");
  tooltip(ui,
          "An NFF file, or a standard scene such as spd:gears:4. Enter opens it. A file can "
          "also be dropped anywhere on the window.");
}

void size_field(const Ui& ui, State& state, const SpdChoice& choice) {
  const SpdScene& scene = spd_scenes()[static_cast<std::size_t>(choice.index)];
  if (!scene.has_size) return;
  begin_row(ui, {"scene.size", "Size factor",
                 "How often the standard scene repeats itself. The "
                 "number of objects grows fast with it."});
  int size = choice.size;
  ImGui::InputInt("##size", &size, 1, 1, ImGuiInputTextFlags_EnterReturnsTrue);
  ui.note("scene.size");
  size = std::clamp(size, 1, 1000);
  if (size != choice.size) open_source(state, source_of({choice.index, size}));
}

void standard_scenes(const Ui& ui, State& state) {
  const SpdChoice choice = spd_choice(state.source);
  std::vector<std::string_view> names;
  for (const SpdScene& scene : spd_scenes()) names.push_back(scene.name);
  int index = choice.index;
  if (combo_row(ui,
                {"scene.standard", "Standard",
                 "The scenes of the Standard Procedural "
                 "Databases (Haines 1987)."},
                names, index))
    open_source(state,
                source_of({index, spd_scenes()[static_cast<std::size_t>(index)].standard_size}));
  else if (choice.index >= 0)
    size_field(ui, state, choice);
}

std::string kinds(const ObjectCounts& counts) {
  std::string text;
  const auto add = [&text](std::size_t number, const char* singular, const char* plural) {
    if (number > 0) text += (text.empty() ? "" : ", ") + counted(number, singular, plural);
  };
  add(counts.triangles, "triangle", "triangles");
  add(counts.polygons, "polygon", "polygons");
  add(counts.patches, "patch", "patches");
  add(counts.spheres, "sphere", "spheres");
  add(counts.cones, "cone", "cones");
  return text;
}

void facts(const Ui& ui, const LoadedScene& loaded) {
  ImGui::TextUnformatted(counted(loaded.counts.objects, "object", "objects").c_str());
  ImGui::SameLine();
  dim_text(ui, counted(loaded.scene.lights.size(), "light", "lights"));
  wrapped_text(ui, kinds(loaded.counts), ui.palette.dim_text);
  if (loaded.counts.degenerate > 0)
    wrapped_text(ui,
                 counted(loaded.counts.degenerate, "object", "objects") +
                     " without area, length or radius, or too far away: never hit",
                 ui.palette.worse);
  if (!loaded.bounds.empty())
    wrapped_text(ui, point(loaded.bounds.lo) + " to " + point(loaded.bounds.hi),
                 ui.palette.dim_text);
}

}  // namespace

void scene_panel(const Ui& ui, const Results& results, State& state) {
  if (!section(ui, "Scene", state.look.closed_sections)) return;
  const IdScope id("scene");
  source_field(ui, state);
  standard_scenes(ui, state);
  if (results.scene_error) wrapped_text(ui, results.scene_error->message, ui.palette.problem);
  if (results.scene_busy)
    dim_text(ui, "Loading…");
  else if (results.scene)
    facts(ui, *results.scene);
}

}  // namespace bspview
