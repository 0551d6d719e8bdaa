#include "app/viewer/panels/ray_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "app/viewer/overlays/ray_table.h"
#include "app/viewer/panels/scopes.h"
#include "app/viewer/panels/widgets.h"

namespace bspview {
namespace {

constexpr int least_listed_rays = 4;  // lines of the list before it scrolls
constexpr float list_share = 0.3f;    // of the panel's height that the list may take

void heading(const Ui& ui, const State& state) {
  {
    const FontScope bold(ui.fonts.bold);
    ImGui::TextUnformatted("Ray");
  }
  if (!state.pick) return;
  ImGui::SameLine();
  dim_text(ui, fmt::format("of pixel {}, {}", state.pick->pixel.column, state.pick->pixel.row));
}

void ray_list(const Ui& ui, std::span<const PathRay> rays, RaySelection& selection) {
  const float line = ImGui::GetTextLineHeightWithSpacing();
  const int fitting = static_cast<int>(list_share * ImGui::GetContentRegionAvail().y / line);
  const int lines = std::min(static_cast<int>(rays.size()), std::max(fitting, least_listed_rays));
  ImGui::BeginChild("rays", {0.0f, line * static_cast<float>(lines) + ui.px(2)});
  for (int i = 0; i < static_cast<int>(rays.size()); ++i) {
    const PathRay& ray = rays[static_cast<std::size_t>(i)];
    const IdScope id(i);
    const float indent = ui.px(12.0f * static_cast<float>(ray.level - 1));
    if (indent > 0.0f) ImGui::Indent(indent);
    if (ImGui::Selectable(ray_title(ray, i).c_str(), i == selection.ray)) selection = {i, -1};
    ui.note(fmt::format("ray.{}", i));
    if (indent > 0.0f) ImGui::Unindent(indent);
  }
  ImGui::EndChild();
}

/// "x = 1.25: near, far" or "leaf: 2, hits object 7 at 1.31".
std::string walk_text(const RayTableRow& row) {
  return row.split.empty() ? row.visits + ": " + row.tests : row.split + ": " + row.visits;
}

void step_row(const Ui& ui, const RayTableRow& row, int index, State& state) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const IdScope id(index);
  if (ImGui::Selectable(row.step.c_str(), state.ray.step == index,
                        ImGuiSelectableFlags_SpanAllColumns))
    state.ray.step = state.ray.step == index ? -1 : index;
  if (ImGui::IsItemHovered()) state.hovered_step = index;
  ui.note(fmt::format("step.{}", index));
  if (!row.t_split.empty()) tooltip(ui, "Meets the plane at t = " + row.t_split);
  ImGui::TableNextColumn();
  dim_text(ui, row.node);
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(walk_text(row).c_str());
  ImGui::TableNextColumn();
  dim_text(ui, row.interval);
}

void step_table(const Ui& ui, const PathRay& ray, State& state) {
  const std::vector<RayTableRow> rows = ray_table(ray);
  const TableScope table("steps", 4,
                         ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg |
                             ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoSavedSettings,
                         ImGui::GetContentRegionAvail());
  if (!table) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  for (const char* head : {"#", "node", "plane, or tests in the leaf", "t in the cell"})
    ImGui::TableSetupColumn(head);
  {
    const ColorScope dim(ImGuiCol_Text, ui.palette.dim_text);
    ImGui::TableHeadersRow();
  }
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(rows.size()));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      step_row(ui, rows[static_cast<std::size_t>(i)], i, state);
}

}  // namespace

void ray_panel(const Ui& ui, const Results& results, State& state) {
  heading(ui, state);
  if (!results.rays || results.rays->rays.empty()) {
    wrapped_text(ui, "Click a pixel of the picture to see its rays step through the tree.",
                 ui.palette.dim_text);
    return;
  }
  const int last = static_cast<int>(results.rays->rays.size()) - 1;
  state.ray.ray = std::clamp(state.ray.ray, 0, last);
  ray_list(ui, results.rays->rays, state.ray);
  const PathRay& ray = results.rays->rays[static_cast<std::size_t>(state.ray.ray)];
  ImGui::Separator();
  dim_text(ui, ray_summary(ray));
  step_table(ui, ray, state);
}

}  // namespace bspview
