#include "app/viewer/exported_state.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "app/viewer/panels/status_bar.h"
#include "core/base/file.h"

namespace bspview {
namespace {

using nlohmann::json;

template <class T>
json optional_json(const std::optional<T>& value) {
  return value ? json(*value) : json();
}

json delta_json(const Delta& delta) {
  return {{"N_LS", delta.n_ls},
          {"R_ETNLS", optional_json(delta.r_etnls)},
          {"N_ADL", optional_json(delta.n_adl)},
          {"N_AOIAL", optional_json(delta.n_aoial)},
          {"N_AOIFL", optional_json(delta.n_aoifl)},
          {"R_FVWV", optional_json(delta.r_fvwv)},
          {"N_RPRT", optional_json(delta.n_rprt)},
          {"N_AT", optional_json(delta.n_at)}};
}

json build_json(const BuildParams& build) {
  return {{"builder", name_of(build.builder)},
          {"max_depth", optional_json(build.max_depth)},
          {"leaf_size", build.leaf_size},
          {"clip", effective_clip(build)}};
}

json scene_json(const Results& results) {
  json node{{"busy", results.scene_busy}, {"error", nullptr}};
  if (results.scene_error) node["error"] = results.scene_error->message;
  if (!results.scene) return node;
  node["source"] = results.scene->source;
  node["objects"] = results.scene->counts.objects;
  return node;
}

json tree_json(const Results& results) {
  if (!results.tree) return nullptr;
  const TreeStats& stats = results.tree->stats;
  return {{"busy", results.tree_busy},
          {"source", results.tree->request.scene->source},
          {"params", build_json(results.tree->request.params)},
          {"leaves", stats.leaves},
          {"deepest_leaf", stats.deepest_leaf}};
}

json picture_json(const Results& results) {
  if (!results.picture) return nullptr;
  const Picture& picture = *results.picture;
  const Camera& camera = picture.request.camera;
  return {{"busy", results.picture_busy},
          {"width", picture.request.params.width},
          {"height", picture.request.params.height},
          {"samples", picture.request.params.samples},
          {"adaptive", picture.request.params.adaptive},
          {"cutoff", picture.request.params.cutoff},
          {"pass", picture.pass},
          {"pass_count", picture.pass_count},
          {"converged", picture.converged()},
          {"from", {camera.from.x, camera.from.y, camera.from.z}},
          {"at", {camera.at.x, camera.at.y, camera.at.z}}};
}

json pick_json(const App& app) {
  if (!app.state().pick) return nullptr;
  json node{{"x", app.state().pick->pixel.column}, {"y", app.state().pick->pixel.row}};
  node["ray"] = app.state().ray.ray;
  node["step"] = app.state().ray.step;
  node["rays"] = app.results().rays ? app.results().rays->rays.size() : 0;
  if (app.results().rays) node["steps"] = app.results().rays->rays.front().log.steps.size();
  return node;
}

json overlay_json(const App& app) {
  const State& state = app.state();
  json node{{"boxes", state.boxes.visible}, {"path", state.path_visible}, {"lines", 0}};
  if (app.results().overlay) {
    node["lines"] = app.results().overlay->lines;
    node["highlighted_step"] = app.results().overlay->request.selection.step;
  }
  return node;
}

json accuracy_json(const App& app) {
  if (!app.results().accuracy) return nullptr;
  const PixelFaults& faults = app.results().accuracy->faults;
  return {{"checked", faults.checked},   {"complete", faults.complete},
          {"lost", faults.lost},         {"phantom", faults.phantom},
          {"self_hit", faults.self_hit}, {"points", app.results().accuracy->points.size()}};
}

/// Names of scenes and files may hold any bytes.
std::string text_of(const json& node) {
  return node.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string export_state(const App& app) {
  const State& state = app.state();
  const Results& results = app.results();
  json node{{"busy", app.busy()},
            {"work", work_text(results)},
            {"scene", scene_json(results)},
            {"build", build_json(state.build)},
            {"tree", tree_json(results)},
            {"picture", picture_json(results)},
            {"pick", pick_json(app)},
            {"overlay", overlay_json(app)},
            {"accuracy", accuracy_json(app)},
            {"help", state.help_visible},
            {"panels", state.panels_visible},
            {"theme", state.look.theme == Theme::light ? "light" : "dark"},
            {"scale", state.look.scale},
            {"delta", nullptr},
            {"before", nullptr}};
  if (results.now) node["delta"] = delta_json(results.now->delta);
  if (results.before) node["before"] = delta_json(results.before->delta);
  return text_of(node);
}

std::string export_widgets(const WidgetMap& widgets) {
  json node = json::object();
  for (const auto& [name, rect] : widgets) node[name] = {rect.x, rect.y, rect.width, rect.height};
  return text_of(node);
}

Result<void> ExportedFile::update(std::string text) {
  if (text == text_) return {};
  text_ = std::move(text);
  return write_file(file_, text_);
}

}  // namespace bspview
