#include "app/viewer/panels/overlay_panel.h"

#include <algorithm>
#include <array>

#include "app/viewer/panels/numbers.h"
#include "app/viewer/panels/scopes.h"
#include "app/viewer/panels/widgets.h"

namespace bspview {
namespace {

constexpr std::array<std::string_view, 2> cell_names{"seen and picked", "all"};
constexpr std::array<std::string_view, 3> content_names{"full and empty", "full", "empty"};
constexpr std::array<std::string_view, 3> color_names{"one colour", "objects", "depth"};

template <class Enum, std::size_t n>
void enum_row(const Ui& ui, const Label& label, const std::array<std::string_view, n>& names,
              Enum& value) {
  int index = static_cast<int>(value);
  if (combo_row(ui, label, names, index)) value = static_cast<Enum>(index);
}

void depth_rows(const Ui& ui, const Results& results, LeafFilter& filter) {
  const int deepest = results.tree ? results.tree->stats.deepest_leaf : depth_cap;
  begin_row(ui, {"boxes.depth", "Depth", "Leaves at these depths. The root has depth 0."});
  int range[2] = {std::min(filter.min_depth, deepest), std::min(filter.max_depth, deepest)};
  const bool changed =
      ImGui::SliderInt2("##depth", range, 0, deepest, "%d", ImGuiSliderFlags_AlwaysClamp);
  ui.note("boxes.depth");
  if (!changed) return;
  const auto [lo, hi] = std::minmax(range[0], range[1]);
  filter.min_depth = lo;
  filter.max_depth = hi == deepest ? depth_cap : hi;
}

void box_rows(const Ui& ui, const Results& results, BoxView& boxes) {
  enum_row(ui,
           {"boxes.cells", "Cells",
            "Seen and picked: those that the visible surface or the picked ray touches."},
           cell_names, boxes.cells);
  depth_rows(ui, results, boxes.filter);
  enum_row(ui, {"boxes.contents", "Contents", "Full leaves hold objects, empty ones none."},
           content_names, boxes.filter.contents);
  enum_row(ui, {"boxes.color", "Colour", "What the colour of a box says; see the legend."},
           color_names, boxes.color_by);
  int map = static_cast<int>(boxes.map);
  if (boxes.color_by != LeafColor::plain &&
      combo_row(ui, {"boxes.map", "Colour map", ""}, color_map_names(), map))
    boxes.map = static_cast<ColorMap>(map);
  check_row(ui,
            {"boxes.borders", "Borders on surfaces",
             "Where the visible surface passes from one leaf to the next."},
            boxes.borders);
}

}  // namespace

void overlay_panel(const Ui& ui, const Results& results, State& state) {
  if (!section(ui, "Overlays", state.look.closed_sections)) return;
  const IdScope id("overlays");
  check_row(ui,
            {"overlay.path", "Path of the picked ray",
             "Click a pixel: its ray, the cells it visits and the objects tested there. Key P"},
            state.path_visible);
  check_row(ui, {"overlay.boxes", "Leaf boxes", "The cells of the tree's leaves. Key B"},
            state.boxes.visible);
  if (state.boxes.visible) box_rows(ui, results, state.boxes);
}

}  // namespace bspview
