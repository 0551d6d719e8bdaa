#include "app/viewer/panels/status_bar.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/viewer/panels/numbers.h"
#include "app/viewer/panels/widgets.h"

namespace bspview {
namespace {

constexpr float progress_width = 90.0f;  // design pixels

/// Whole ones that are reached; what is told may fall short of all by rounding.
int percent(double share) {
  return std::clamp(static_cast<int>(100.0 * share + 1e-6), 0, 100);
}

float progress(const Results& results) {
  if (results.scene_busy) return 0.0f;
  if (results.tree_busy) return static_cast<float>(results.tree_progress);
  if (!results.picture) return 0.0f;
  if (results.picture->pass_count == 0) return 0.0f;
  return static_cast<float>(results.picture->pass) /
         static_cast<float>(results.picture->pass_count);
}

}  // namespace

std::string work_text(const Results& results) {
  if (results.scene_busy) return "loading";
  if (results.tree_busy) return fmt::format("building tree, {} %", percent(results.tree_progress));
  if (results.picture_busy && results.picture)
    return fmt::format("pass {} of {}", results.picture->pass, results.picture->pass_count);
  if (results.measures_busy) return "measuring";
  return "";
}

std::string status_text(const Results& results) {
  std::string text;
  const auto add = [&text](const std::string& fact) {
    text += (text.empty() ? "" : "  ·  ") + fact;
  };
  if (results.tree) {
    constexpr const char* made[] = {"build ", "cut ", "sketch "};  // as the enumerators of Origin
    add(made[static_cast<std::size_t>(results.tree->origin)] +
        duration(results.tree->tree.build_seconds));
    add(memory(static_cast<double>(results.tree->tree.bytes())));
  }
  if (results.now && results.now->delta.n_at)
    add(significant(*results.now->delta.n_at, 3) + " nodes per ray");
  if (results.now && results.now->rays && results.now->lambda.t_tr)
    add(significant(
            1e-6 * static_cast<double>(results.now->rays->all()) / results.now->lambda.t_tr->median,
            3) +
        " Mrays/s");
  return text;
}

void status_bar(const Ui& ui, const Results& results) {
  dim_text(ui, status_text(results));
  const std::string work = work_text(results);
  if (work.empty()) return;
  const float bar = ui.px(progress_width);
  const float text = ImGui::CalcTextSize(work.c_str()).x;
  ImGui::SameLine(ImGui::GetWindowWidth() - bar - text - ui.px(24));
  dim_text(ui, work);
  ImGui::SameLine();
  const float height = ui.px(4);
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + (ImGui::GetTextLineHeight() - height) / 2);
  ImGui::ProgressBar(progress(results), {bar, height}, "");
}

}  // namespace bspview
