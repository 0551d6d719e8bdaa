#include "app/viewer/panels/measures_panel.h"

#include <array>
#include <string>
#include <utility>

#include "app/viewer/panels/measure_rows.h"
#include "app/viewer/panels/numbers.h"
#include "app/viewer/panels/scopes.h"
#include "app/viewer/panels/widgets.h"

namespace bspview {
namespace {

constexpr float symbol_width = 72.0f, change_width = 56.0f, row_padding = 4.5f;  // design pixels
constexpr ImGuiTableFlags measure_table = ImGuiTableFlags_RowBg | ImGuiTableFlags_NoSavedSettings;

const ImVec4& change_color(const Ui& ui, double benefit) {
  if (benefit == 0.0) return ui.palette.dim_text;
  return benefit > 0.0 ? ui.palette.better : ui.palette.worse;
}

struct Heading {
  const char *letter, *word, *text;
};

void heading(const Ui& ui, const Heading& of) {
  const FontScope bold(ui.fonts.bold);
  ImGui::TextUnformatted(ui.fonts.greek ? of.letter : of.word);
  tooltip(ui, of.text);
}

void table_head(const Ui& ui, const Heading& of, const Evaluation& now) {
  ImGui::TableSetupColumn("symbol", ImGuiTableColumnFlags_WidthFixed, ui.px(symbol_width));
  ImGui::TableSetupColumn("now", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("before", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("change", ImGuiTableColumnFlags_WidthFixed, ui.px(change_width));
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  heading(ui, of);
  const ColorScope dim(ImGuiCol_Text, ui.palette.dim_text);
  const bool is_sketch = now.origin == BuiltTree::Origin::sketch;
  for (const char* head : {is_sketch ? "sketch" : "now", "before", "change"}) {
    ImGui::TableNextColumn();
    right_aligned(head);
  }
}

void measure_row(const Ui& ui, const MeasureRow& row) {
  ImGui::TableNextRow(0, ImGui::GetTextLineHeight() + ui.px(row_padding));
  ImGui::TableNextColumn();
  ImGui::BeginGroup();
  symbols(ui, row.symbol);
  if (row.derived) {
    ImGui::SameLine(0.0f, ui.px(3));
    dim_text(ui, "*");
  }
  ImGui::EndGroup();
  ui.note(std::string("measure.") + row.name);
  tooltip(ui, row.meaning);
  ImGui::TableNextColumn();
  right_aligned(row.now);
  const ColorScope dim(ImGuiCol_Text, ui.palette.dim_text);
  ImGui::TableNextColumn();
  right_aligned(row.before);
  ImGui::TableNextColumn();
  const ColorScope color(ImGuiCol_Text, change_color(ui, row.benefit));
  right_aligned(row.change);
}

void delta_table(const Ui& ui, const Evaluation& now, const Evaluation* before) {
  const TableScope table("delta", 4, measure_table);
  if (!table) return;
  table_head(ui,
             {"Δ", "Delta",
              "What the tree and the rays of this picture cost. Every ray is counted: primary, "
              "reflected, refracted and shadow rays.\n* derived from the others"},
             now);
  for (const MeasureRow& row : delta_rows(now, before)) measure_row(ui, row);
}

void lambda_table(const Ui& ui, const Evaluation& now, const Evaluation* before) {
  const TableScope table("lambda", 4, measure_table);
  if (!table) return;
  table_head(ui, {"Λ", "Lambda", "What the tree and this picture take in time."}, now);
  for (const MeasureRow& row : lambda_rows(now, before)) measure_row(ui, row);
}

void ray_counts(const Ui& ui, const RayCounts& rays) {
  const std::array<std::pair<const char*, std::uint64_t>, 8> cells{{
      {"primary", rays.primary},
      {"all rays", rays.all()},
      {"reflected", rays.reflected},
      {"with a hit", rays.minimal_tests()},
      {"refracted", rays.refracted},
      {"tests", rays.tests},
      {"shadow", rays.shadow},
      {"node visits", rays.nodes_inner + rays.nodes_leaf},
  }};
  const TableScope table("rays", 4, ImGuiTableFlags_SizingStretchProp);
  if (!table) return;
  for (const auto& [name, count] : cells) {
    ImGui::TableNextColumn();
    dim_text(ui, name);
    ImGui::TableNextColumn();
    right_aligned(with_thousands(count));
  }
}

}  // namespace

void measures_panel(const Ui& ui, const Results& results, State& state) {
  if (!results.now) {
    dim_text(ui, "No numbers without a tree.");
    return;
  }
  const Evaluation* before = results.before ? &*results.before : nullptr;
  delta_table(ui, *results.now, before);
  lambda_table(ui, *results.now, before);
  if (results.now->rays) ray_counts(ui, *results.now->rays);
  check_row(ui,
            {"measure.times", results.measures_busy ? "Measuring times…" : "Measure times at rest",
             "T_TR and T_TT are measured as soon as the picture has converged and nothing moves."},
            state.measure_times);
}

}  // namespace bspview
