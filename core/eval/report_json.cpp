#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/eval/machine_json.h"
#include "core/eval/report.h"
#include "core/eval/symbols.h"

namespace bspview {
namespace {

using Json = nlohmann::ordered_json;

/// A float by its own shortest decimal number, not by that of the double it becomes.
Json shortest(float value) {
  if (!std::isfinite(value)) return nullptr;
  char digits[32];
  const char* end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  double same = 0.0;
  std::from_chars(digits, end, same);
  return same;
}

Json shortest(Vec3 v) {
  return Json::array({shortest(v.x), shortest(v.y), shortest(v.z)});
}

Json or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

/// `values`, or the same keys without values where there are none.
Json keys_of(Json values, bool known) {
  if (!known) {
    for (auto& value : values) value = nullptr;
  }
  return values;
}

Json scene_json(const Report& report) {
  const ObjectCounts& count = report.objects;
  Json json{{"name", report.scene_name},    {"objects", count.objects},
            {"triangles", count.triangles}, {"polygons", count.polygons},
            {"patches", count.patches},     {"spheres", count.spheres},
            {"cones", count.cones},         {"degenerate", count.degenerate}};
  json["bounds_min"] = report.bounds.empty() ? Json(nullptr) : shortest(report.bounds.lo);
  json["bounds_max"] = report.bounds.empty() ? Json(nullptr) : shortest(report.bounds.hi);
  return json;
}

Json build_json(const Report& report) {
  const BuildParams params = report.tree ? report.tree->params : BuildParams{};
  const Traversal traversal = report.tree ? report.tree->traversal : Traversal::robust;
  return keys_of({{"builder", name_of(params.builder)},
                  {"max_depth", params.max_depth.value_or(0)},
                  {"leaf_size", params.leaf_size},
                  {"clip", params.clip.value_or(false)},
                  {"threads", params.threads},
                  {"cost_traversal", shortest(params.cost_traversal)},
                  {"cost_intersection", shortest(params.cost_intersection.value_or(0.0f))},
                  {"empty_bonus", shortest(params.empty_bonus)},
                  {"traversal", name_of(traversal)},
                  {"lazy", params.lazy},
                  {"memory_limit", params.memory_limit},
                  {"memory_limit_reached", report.tree && report.tree->memory_limit_reached},
                  {"seed", report.seed}},
                 report.tree.has_value());
}

/// [objects in the leaf, leaves with as many] for every number that occurs.
Json leaf_sizes(const TreeStats& stats) {
  Json pairs = Json::array();
  for (std::size_t size = 0; size < stats.leaves_with_count.size(); ++size) {
    const std::uint64_t leaves = stats.leaves_with_count[size];
    if (leaves != 0) pairs.push_back(Json::array({size, leaves}));
  }
  return pairs;
}

Json tree_json(const Report& report) {
  const TreeStats stats = report.tree ? report.tree->stats : TreeStats{};
  return keys_of({{"nodes", stats.nodes},
                  {"interior", stats.inner},
                  {"leaves", stats.leaves},
                  {"empty_leaves", stats.empty_leaves},
                  {"references", stats.references},
                  {"deepest_leaf", stats.deepest_leaf},
                  {"bytes", report.tree ? report.tree->bytes : 0},
                  {"expected_cost", or_null(stats.expected_cost)},
                  {"leaves_at_depth", stats.leaves_at_depth},
                  {"leaves_with_objects", leaf_sizes(stats)},
                  {"unbuilt_leaves", report.tree ? report.tree->unbuilt_leaves : 0},
                  {"unbuilt_references", report.tree ? report.tree->unbuilt_references : 0}},
                 report.tree.has_value());
}

Json delta_json(const Report& report) {
  const Delta delta = report.delta.value_or(Delta{});
  const auto values = values_of(delta);
  Json json = Json::object();
  for (std::size_t i = 0; i < delta_size; ++i) {
    json[std::string(delta_symbols()[i].key)] = or_null(values[i]);
  }
  json["N_LS"] = delta.n_ls;
  return keys_of(std::move(json), report.delta.has_value());
}

Json lambda_json(const Report& report) {
  const auto values = values_of(report.lambda.value_or(Lambda{}));
  Json json = Json::object();
  for (std::size_t i = 0; i < lambda_size; ++i) {
    const std::string key(lambda_symbols()[i].key);
    json[key] = values[i] ? or_null(values[i]->median) : Json(nullptr);
    if (values[i] && values[i]->repeats > 1) json[key + "_spread"] = or_null(values[i]->spread);
  }
  if (report.first_picture_seconds) json["first_picture"] = *report.first_picture_seconds;
  if (values.back()) json["T_TT_method"] = traversal_time_method();
  return json;
}

Json rays_json(const Report& report) {
  const RayCounts rays = report.rays.value_or(RayCounts{});
  return keys_of({{"primary", rays.primary},
                  {"reflected", rays.reflected},
                  {"refracted", rays.refracted},
                  {"shadow", rays.shadow},
                  {"all", rays.all()},
                  {"primary_hits", rays.primary_hits},
                  {"secondary_hits", rays.secondary_hits},
                  {"shadow_hits", rays.shadow_hits},
                  {"minimal_tests", rays.minimal_tests()},
                  {"tests", rays.tests},
                  {"nodes_interior", rays.nodes_inner},
                  {"nodes_leaf", rays.nodes_leaf},
                  {"samples_per_pixel", or_null(report.samples_per_pixel)}},
                 report.rays.has_value());
}

}  // namespace

std::string to_json(const Report& report) {
  const Json sections{{"scene", scene_json(report)},
                      {"build", build_json(report)},
                      {"tree", tree_json(report)},
                      {"delta", delta_json(report)},
                      {"lambda", lambda_json(report)},
                      {"rays", rays_json(report)},
                      {"machine", machine_json(report.machine)}};
  std::string text;
  for (const auto& [name, section] : sections.items()) {
    text += text.empty() ? "{\n" : ",\n";
    text += "  \"" + name + "\": ";
    text += section.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  return text + "\n}\n";
}

}  // namespace bspview
