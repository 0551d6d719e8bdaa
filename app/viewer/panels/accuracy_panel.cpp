#include "app/viewer/panels/accuracy_panel.h"

#include "app/viewer/overlays/fault_marks.h"
#include "app/viewer/panels/numbers.h"
#include "app/viewer/panels/scopes.h"
#include "app/viewer/panels/trade_off_chart.h"
#include "app/viewer/panels/widgets.h"

namespace bspview {
namespace {

void arithmetic_rows(const Ui& ui, PictureSettings& picture) {
  int arithmetic = static_cast<int>(picture.arithmetic);
  if (combo_row(ui,
                {"accuracy.arithmetic", "Arithmetic",
                 "float: Möller and Trumbore, the quadratic formula, as in textbooks\n"
                 "woop: triangles watertight after Woop, quadrics as in textbooks\n"
                 "double: Möller and Trumbore in double, stable quadrics in double\n"
                 "exact: faces are hit as exact arithmetic decides, quadrics in double"},
                arithmetic_names(), arithmetic))
    picture.arithmetic = static_cast<Arithmetic>(arithmetic);
  int offset = static_cast<int>(picture.offset);
  if (combo_row(ui,
                {"accuracy.offset", "Ray offset",
                 "What keeps a ray from hitting the surface that it leaves.\n"
                 "tmin: hits before t = 0.0001 are ignored\n"
                 "bounded: the ray starts off the surface by the error of the hit point"},
                offset_rule_names(), offset))
    picture.offset = static_cast<OffsetRule>(offset);
}

void fault_row(const Ui& ui, PixelFault fault, const char* name, std::size_t count) {
  ImGui::TableNextColumn();
  {
    const ImVec4 color = ImGui::ColorConvertU32ToFloat4(fault_color(fault));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float size = ImGui::GetTextLineHeight();
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + size * 0.25f},
                                              {at.x + size * 0.6f, at.y + size * 0.85f},
                                              ImGui::GetColorU32(color));
    ImGui::Dummy({size * 0.6f, size});
  }
  ImGui::SameLine();
  dim_text(ui, name);
  ImGui::TableNextColumn();
  right_aligned(with_thousands(count));
}

void fault_table(const Ui& ui, const PixelFaults& faults) {
  const TableScope table("faults", 2, ImGuiTableFlags_SizingStretchProp);
  if (!table) return;
  fault_row(ui, PixelFault::lost, "lost: went through a surface  +", faults.lost);
  fault_row(ui, PixelFault::phantom, "phantom: nothing is there  ×", faults.phantom);
  fault_row(ui, PixelFault::self_hit, "self-hit: shaded by itself  ■", faults.self_hit);
  ImGui::TableNextColumn();
  dim_text(ui, "pixels checked");
  ImGui::TableNextColumn();
  right_aligned(with_thousands(faults.checked));
}

}  // namespace

void accuracy_panel(const Ui& ui, const Results& results, State& state) {
  if (!section(ui, "Accuracy", state.look.closed_sections)) return;
  const IdScope id("accuracy");
  arithmetic_rows(ui, state.picture);
  check_row(ui,
            {"accuracy.check",
             results.accuracy_busy ? "Checking pixels…" : "Check pixels against exact hits",
             "Once nothing moves, the eye ray of every pixel and its shadow rays are judged by "
             "exact arithmetic; wrong pixels are marked in the picture. Then every arithmetic and "
             "traversal is measured on rays of this view."},
            state.check_pixels);
  if (!state.check_pixels || !results.accuracy) return;
  fault_table(ui, results.accuracy->faults);
  trade_off_chart(ui, results.accuracy->points,
                  {state.picture.arithmetic, state.picture.traversal});
}

}  // namespace bspview
