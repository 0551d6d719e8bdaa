#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/eval/error/report.h"

#include "core/eval/machine_json.h"

namespace bspview {
namespace {

using Json = nlohmann::ordered_json;

Json estimate_json(const std::optional<Estimate>& estimate) {
  if (!estimate) return nullptr;
  return {{"value", estimate->value}, {"is_bound", estimate->is_bound}};
}

Json hits_json(const HitCounts& hits) {
  return {{"rays", hits.rays},
          {"lost", hits.lost},
          {"phantom", hits.phantom},
          {"undecided", hits.undecided},
          {"leaks", hits.leaks}};
}

Json config_json(const ErrorConfig& config) {
  Json json{{"name", config.name}, {"what", config.what}};
  for (const char* factor : {"faces", "quadrics", "traversal", "tree", "offset"}) {
    json[factor] = nullptr;
  }
  if (!config.choice) return json;
  json["faces"] = name_of(config.choice->faces);
  json["quadrics"] = name_of(config.choice->quadrics);
  json["traversal"] = name_of(config.choice->traversal);
  json["tree"] = name_of(config.builder);
  json["offset"] = name_of(config.choice->offset);
  return json;
}

Json counts_json(const ErrorCounts& counts) {
  Json json = Json::object();
  for (std::size_t i = 0; i < ray_group_count; ++i) {
    json[std::string(name_of(static_cast<RayGroup>(i)))] = hits_json(counts.hits[i]);
  }
  const OffsetCounts& offset = counts.offset;
  json["leaving_rays"] = offset.leaving;
  json["acne"] = offset.acne;
  json["hidden_shadow_rays"] = offset.hidden;
  json["light_leaks"] = offset.leaks;
  return json;
}

Json seconds_json(const std::array<std::vector<double>, ray_group_count>& seconds) {
  Json json = Json::object();
  for (std::size_t i = 0; i < ray_group_count; ++i) {
    if (!seconds[i].empty()) json[std::string(name_of(static_cast<RayGroup>(i)))] = seconds[i];
  }
  return json;
}

Json scene_json(const SceneErrors& scene) {
  Json json{{"name", scene.name},
            {"objects", scene.objects.objects},
            {"only_triangles", scene.only_triangles}};
  for (std::size_t i = 0; i < scene.counts.size(); ++i) {
    if (scene.measured[i] == 0) {
      json["configurations"].push_back(nullptr);
      continue;
    }
    json["configurations"].push_back(
        {{"counts", counts_json(scene.counts[i])}, {"seconds", seconds_json(scene.seconds[i])}});
  }
  return json;
}

Json pool_json(const ErrorReport& report, const ErrorPool& pool) {
  Json json = Json::object();
  for (const std::size_t scene : pool.scenes) json["scenes"].push_back(report.scenes[scene].name);
  for (const PooledConfig& one : pool.configs) {
    Json row{{"name", report.configs[one.config].name},
             {"ns_per_ray", one.ns},
             {"ns_per_ray_mad", one.ns_mad}};
    for (std::size_t i = 0; i < metric_count; ++i) {
      const auto metric = static_cast<Metric>(i);
      row[std::string(text_of(metric).key)] = estimate_json(estimate(one.counts, metric));
    }
    json["configurations"].push_back(std::move(row));
  }
  for (std::size_t i = 0; i < metric_count; ++i) {
    const TradeOffs all = trade_offs(pool, static_cast<Metric>(i));
    const auto name = [&](std::size_t point) {
      return report.configs[pool.configs[all.members[point]].config].name;
    };
    Json front = Json::array();
    for (const std::size_t point : pareto_front(all.points)) front.push_back(name(point));
    const auto knee = pareto_knee(all.points);
    json["fronts"][std::string(text_of(static_cast<Metric>(i)).key)] = {
        {"configurations", std::move(front)}, {"knee", knee ? Json(name(*knee)) : Json(nullptr)}};
  }
  return json;
}

Json price_json(std::size_t config, const ErrorReport& report) {
  const Price price = price_of(config, report);
  Json json{{"against", report.configs[price.fastest].name}, {"scenes", Json::object()}};
  for (std::size_t i = 0; i < price.ratios.size(); ++i) {
    for (std::size_t k = 0; k < priced_groups.size(); ++k) {
      const double ratio = price.ratios[i][k];
      json["scenes"][report.scenes[i].name][std::string(name_of(priced_groups[k]))] =
          ratio > 0.0 ? Json(ratio) : Json(nullptr);
    }
  }
  for (std::size_t k = 0; k < priced_groups.size(); ++k) {
    json["median"][std::string(name_of(priced_groups[k]))] = price.medians[k];
  }
  return json;
}

Json image_json(const SceneImageError& image) {
  Json json{{"scene", image.scene},
            {"width", image.params.render.width},
            {"height", image.params.render.height},
            {"reference_samples", image.params.reference_samples}};
  for (const ImageErrorCurve& curve : image.curves) {
    Json points = Json::array();
    for (const ImageErrorPoint& point : curve.points) {
      points.push_back({{"name", point.name},
                        {"samples_per_pixel", point.samples_per_pixel},
                        {"seconds", point.seconds.median},
                        {"seconds_spread", point.seconds.spread},
                        {"repeats", point.seconds.repeats},
                        {"rmse", point.rmse},
                        {"rel_mse", point.rel_mse},
                        {"bias_signed", point.bias.signed_mean},
                        {"bias_absolute", point.bias.absolute_mean},
                        {"bias_rms", point.bias.root_mean_square}});
    }
    json["curves"].push_back({{"name", curve.name}, {"points", std::move(points)}});
  }
  return json;
}

void add_rays(Json& json, const ErrorReport& report) {
  const ErrorParams& params = report.params;
  json["parameters"] = {{"rays", params.rays},
                        {"repeats", params.repeats},
                        {"timing_threads", params.timing_threads},
                        {"seed", params.seed}};
  for (const Factor factor : report.strongest_factors) {
    json["strongest_factors"].push_back(name_of(factor));
  }
  for (const ErrorConfig& config : report.configs) {
    json["configurations"].push_back(config_json(config));
  }
  json["all"] = pool_json(report, pool_of_all(report));
  json["triangles"] = pool_json(report, pool_of_triangles(report));
  json["price"] = price_json(report.pictures_config, report);
  json["price_in_binary_tree"] = price_json(default_config, report);
  for (const SceneErrors& scene : report.scenes) json["scenes"].push_back(scene_json(scene));
}

}  // namespace

std::string to_json(const ErrorStudy& study) {
  Json json{{"verdict", fmt::format("{}", fmt::join(verdict(study), " "))}};
  if (!study.rays.scenes.empty()) add_rays(json, study.rays);
  json["images"] = Json::array();
  for (const SceneImageError& image : study.images) json["images"].push_back(image_json(image));
  const Machine& machine = study.rays.machine;
  json["machine"] = machine_json(machine);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bspview
