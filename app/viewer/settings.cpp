#include "app/viewer/settings.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/file.h"

namespace bspview {
namespace {

using nlohmann::json;

/// Takes over `node[key]` where it is a number from `lo` to `hi`.
template <class T>
void take_number(const json& node, const char* key, T lo, T hi, T& value) {
  const auto found = node.find(key);
  if (found == node.end() || !found->is_number()) return;
  const double number = found->get<double>();
  if (!std::isfinite(number)) return;
  value = static_cast<T>(std::clamp(number, static_cast<double>(lo), static_cast<double>(hi)));
}

void take_bool(const json& node, const char* key, bool& value) {
  const auto found = node.find(key);
  if (found != node.end() && found->is_boolean()) value = found->get<bool>();
}

/// Enumerators are kept by number; `last` is the last valid one.
template <class Enum>
void take_enum(const json& node, const char* key, Enum last, Enum& value) {
  int number = static_cast<int>(value);
  take_number(node, key, 0, static_cast<int>(last), number);
  value = static_cast<Enum>(number);
}

json look_to_json(const Look& look) {
  return {{"theme", look.theme == Theme::light ? "light" : "dark"},
          {"scale", look.scale},
          {"left", look.splits.left},
          {"right", look.splits.right},
          {"ray", look.splits.ray},
          {"closed", look.closed_sections}};
}

void take_look(const json& node, Look& look) {
  look.theme = node.value("theme", json()) == "light" ? Theme::light : Theme::dark;
  take_number(node, "scale", least_scale, largest_scale, look.scale);
  take_number(node, "left", 0.0f, 1e4f, look.splits.left);
  take_number(node, "right", 0.0f, 1e4f, look.splits.right);
  take_number(node, "ray", 0.0f, 1.0f, look.splits.ray);
  for (const json& name : node.value("closed", json::array()))
    if (name.is_string()) look.closed_sections.insert(name.get<std::string>());
}

json boxes_to_json(const BoxView& boxes) {
  return {{"visible", boxes.visible},
          {"cells", static_cast<int>(boxes.cells)},
          {"contents", static_cast<int>(boxes.filter.contents)},
          {"color_by", static_cast<int>(boxes.color_by)},
          {"map", static_cast<int>(boxes.map)},
          {"borders", boxes.borders}};
}

void take_boxes(const json& node, BoxView& boxes) {
  take_bool(node, "visible", boxes.visible);
  take_enum(node, "cells", BoxView::Cells::all, boxes.cells);
  take_enum(node, "contents", LeafFilter::Contents::empty, boxes.filter.contents);
  take_enum(node, "color_by", LeafColor::depth, boxes.color_by);
  take_enum(node, "map", ColorMap::grey, boxes.map);
  take_bool(node, "borders", boxes.borders);
}

json child(const json& node, const char* key) {
  const auto found = node.find(key);
  return found != node.end() && found->is_object() ? *found : json::object();
}

}  // namespace

std::filesystem::path settings_file() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  if (config != nullptr && config[0] == '/')
    return std::filesystem::path(config) / "bspview" / "settings.json";
  const char* home = std::getenv("HOME");
  if (home == nullptr || home[0] != '/') return {};
  return std::filesystem::path(home) / ".config" / "bspview" / "settings.json";
}

Settings load_settings(const std::filesystem::path& file) {
  Settings settings;
  const Result<std::string> text = read_file(file);
  if (!text) return settings;
  const json node = json::parse(*text, nullptr, false);
  if (!node.is_object()) return settings;
  take_number(node, "window_width", 320, 16384, settings.window_width);
  take_number(node, "window_height", 240, 16384, settings.window_height);
  take_look(child(node, "look"), settings.look);
  take_boxes(child(node, "boxes"), settings.boxes);
  take_bool(node, "path_visible", settings.path_visible);
  take_bool(node, "measure_times", settings.measure_times);
  take_number(node, "samples", 1, largest_samples, settings.samples);
  return settings;
}

Result<void> save_settings(const Settings& settings, const std::filesystem::path& file) {
  if (file.empty()) return Error{"there is no folder for settings: HOME is not set"};
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  if (error) return Error{file.parent_path().string() + ": " + error.message()};
  const json node{{"window_width", settings.window_width},
                  {"window_height", settings.window_height},
                  {"look", look_to_json(settings.look)},
                  {"boxes", boxes_to_json(settings.boxes)},
                  {"path_visible", settings.path_visible},
                  {"measure_times", settings.measure_times},
                  {"samples", settings.samples}};
  return write_file(file, node.dump(2) + "\n");
}

void apply_settings(const Settings& settings, State& state) {
  state.look = settings.look;
  state.boxes = settings.boxes;
  state.path_visible = settings.path_visible;
  state.measure_times = settings.measure_times;
  state.picture.samples = settings.samples;
}

Settings settings_of(const State& state, int window_width, int window_height) {
  return {window_width,       window_height,       state.look,           state.boxes,
          state.path_visible, state.measure_times, state.picture.samples};
}

}  // namespace bspview
