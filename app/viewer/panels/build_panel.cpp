#include "app/viewer/panels/build_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/viewer/panels/numbers.h"
#include "app/viewer/panels/scopes.h"
#include "app/viewer/panels/widgets.h"
#include "core/bsp/cut.h"
#include "core/bsp/traversal.h"

namespace bspview {
namespace {

constexpr int largest_leaf_size = 64;
constexpr float automatic_width = 58.0f;  // design pixels, of a check box beside a field
constexpr Label depth_label{"build.max_depth", "Maximal depth",
                            "A node at this depth becomes a leaf. The root has depth 0. "
                            "Keys [ and ]"};
constexpr float mib = 1024.0f * 1024.0f;

std::size_t object_count(const Results& results) {
  return results.scene ? results.scene->counts.objects : 0;
}

DisabledScope::When disabled(bool off) {
  return off ? DisabledScope::When::always : DisabledScope::When::never;
}

void builder_row(const Ui& ui, BuildParams& params) {
  int builder = static_cast<int>(params.builder);
  if (combo_row(ui,
                {"build.builder", "Builder",
                 "naive: no tree, every ray against every object\n"
                 "median: the paper's, mid-point of the axes in turn\n"
                 "median-longest: mid-point of the longest axis\n"
                 "object-median: as many objects on either side\n"
                 "mb: MacDonald and Booth's search between both medians\n"
                 "sah: the cheapest of all planes by the surface area heuristic\n"
                 "sah-binned: about the cheapest in wide nodes, sooner built"},
                builder_names(), builder))
    params.builder = static_cast<Builder>(builder);
}

/// Behind a field: whether its value, else the one shown, is left to the program.
template <class T>
void automatic_check(const Ui& ui, const Label& label, T shown, std::optional<T>& value) {
  ImGui::SameLine();
  bool automatic = !value;
  if (check_row(ui, label, automatic)) value = automatic ? std::nullopt : std::optional(shown);
}

void depth_row(const Ui& ui, const Results& results, BuildParams& params) {
  int depth = effective_depth(params, object_count(results));
  begin_row(ui, depth_label);
  ImGui::SetNextItemWidth(-ui.px(automatic_width));
  if (ImGui::SliderInt("##depth", &depth, 0, depth_cap, "%d", ImGuiSliderFlags_AlwaysClamp))
    params.max_depth = depth;
  ui.note(depth_label.name);
  tooltip(ui, depth_label.tooltip);
  automatic_check(ui,
                  {"build.auto_depth", "auto", "round(8 + 1.3 log2 N) for N objects, as in pbrt"},
                  depth, params.max_depth);
}

void clip_row(const Ui& ui, BuildParams& params) {
  BuildParams automatic = params;
  automatic.clip.reset();
  const std::string by_itself =
      fmt::format("automatic ({})", effective_clip(automatic) ? "on" : "off");
  const std::array<std::string_view, 3> names{by_itself, "on", "off"};
  int index = params.clip ? (*params.clip ? 1 : 2) : 0;
  if (combo_row(ui,
                {"build.clip", "Clipping",
                 "On: an object is in a cell only when its part inside the cell is not empty "
                 "(perfect splits). Off: the object's own box decides."},
                names, index))
    params.clip = index == 0 ? std::nullopt : std::optional(index == 1);
}

bool cost_field(const Ui& ui, const Label& label, float& value) {
  const IdScope id(label.name);
  const bool is_changed = ImGui::DragFloat("##cost", &value, 0.02f, 0.01f, 1000.0f, "%.2f",
                                           ImGuiSliderFlags_AlwaysClamp);
  ui.note(label.name);
  tooltip(ui, label.tooltip);
  return is_changed;
}

void test_cost_row(const Ui& ui, const Results& results, BuildParams& params) {
  constexpr Label label{"build.cost_intersection", "Test cost",
                        "C_I: of testing an object. Only its ratio to the cost of a node matters."};
  const float measured = results.tree ? results.tree->tree.cost_intersection : 1.0f;
  float cost = params.cost_intersection.value_or(measured);
  begin_row(ui, label);
  ImGui::SetNextItemWidth(-ui.px(automatic_width));
  if (cost_field(ui, label, cost)) params.cost_intersection = cost;
  automatic_check(ui,
                  {"build.auto_cost", "auto",
                   "What was measured for each kind of object; the mean over the scene is shown."},
                  cost, params.cost_intersection);
}

void cost_rows(const Ui& ui, const Results& results, BuildParams& params) {
  const DisabledScope scope(disabled(!has_costs(params.builder)));
  constexpr Label label{"build.cost_traversal", "Node cost", "C_T: of visiting an inner node."};
  begin_row(ui, label);
  cost_field(ui, label, params.cost_traversal);
  test_cost_row(ui, results, params);
  slider_row(ui,
             {"build.empty_bonus", "Empty bonus",
              "Share of the tests that a split with one empty side is spared."},
             params.empty_bonus, {0.0f, 0.95f, "%.2f"});
}

void memory_row(const Ui& ui, BuildParams& params) {
  float limit = static_cast<float>(params.memory_limit) / mib;
  if (slider_row(ui,
                 {"build.memory_limit", "Memory limit",
                  "For nodes and references. When it is spent, nodes become leaves."},
                 limit, {1.0f, 16384.0f, "%.0f MiB", true}))
    params.memory_limit = static_cast<std::size_t>(std::round(limit)) * std::size_t{1 << 20};
}

void traversal_row(const Ui& ui, PictureSettings& picture) {
  int traversal = static_cast<int>(picture.traversal);
  if (combo_row(ui,
                {"build.traversal", "Traversal",
                 "sung-shirley: as published in Graphics Gems III\n"
                 "havran: his TA-B, by the cases of the ray's entry and exit\n"
                 "robust: intervals rounded outwards, no hit is lost"},
                traversal_names(), traversal))
    picture.traversal = static_cast<Traversal>(traversal);
}

std::string tree_text(const BuiltTree& built) {
  const TreeStats& stats = built.stats;
  const std::string leaves = counted(stats.leaves, "leaf", "leaves");
  if (built.origin == BuiltTree::Origin::sketch)
    return fmt::format("sketch by {}: {}", name_of(built.request.params.builder), leaves);
  return fmt::format("{}, deepest {}, {}", leaves, stats.deepest_leaf,
                     memory(static_cast<double>(built.tree.bytes())));
}

void summary(const Ui& ui, const Results& results) {
  if (results.tree_error) wrapped_text(ui, results.tree_error->message, ui.palette.problem);
  if (!results.tree) return;
  wrapped_text(ui, tree_text(*results.tree), ui.palette.dim_text);
  if (results.tree->tree.memory_limit_reached)
    wrapped_text(ui, "The memory limit made leaves of nodes that would have been split.",
                 ui.palette.worse);
}

}  // namespace

void build_panel(const Ui& ui, const Results& results, State& state) {
  if (!section(ui, "Build", state.look.closed_sections)) return;
  const IdScope id("build");
  BuildParams& params = state.build;
  builder_row(ui, params);
  {
    const DisabledScope scope(disabled(params.builder == Builder::naive));
    depth_row(ui, results, params);
    slider_row(ui,
               {"build.leaf_size", "Leaf size",
                "A node with at most as many objects becomes a leaf. Keys { and }"},
               params.leaf_size, {1, largest_leaf_size, "%d", true});
    clip_row(ui, params);
    cost_rows(ui, results, params);
    memory_row(ui, params);
  }
  traversal_row(ui, state.picture);
  summary(ui, results);
}

}  // namespace bspview
