#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/counted.h"
#include "core/eval/error/image_tables.h"
#include "core/eval/error/report.h"

namespace bspview {
namespace {

std::string heading(std::string_view title) {
  return fmt::format("\n{}\n", title);
}

std::string scene_names(const ErrorReport& report, std::span<const std::size_t> scenes) {
  std::string names;
  for (const std::size_t i : scenes) {
    names += fmt::format("{}{}", names.empty() ? "" : " ", report.scenes[i].name);
  }
  return names;
}

constexpr std::array ordinary_columns{Metric::wrong_hits, Metric::acne,   Metric::light_leaks,
                                      Metric::t_median,   Metric::t_tail, Metric::t_largest};
constexpr std::array triangle_columns{Metric::edge_leaks, Metric::wrong_hits};

std::string pool_table(const ErrorReport& report, const ErrorPool& pool,
                       std::span<const Metric> columns) {
  std::string text = fmt::format("{:<44} {:>8} {:>6}", "", "ns/ray", "+-");
  for (const Metric metric : columns) text += fmt::format(" {:>11}", text_of(metric).key);
  text += "\n";
  for (const PooledConfig& one : pool.configs) {
    text += fmt::format("{:<44} {:>8.1f} {:>6.1f}", report.configs[one.config].name, one.ns,
                        one.ns_mad);
    for (const Metric metric : columns) {
      text += fmt::format(" {:>11}", format_estimate(estimate(one.counts, metric)));
    }
    text += "\n";
  }
  return text;
}

std::string fronts(const ErrorReport& report, const ErrorPool& pool,
                   std::span<const Metric> columns) {
  std::string text;
  for (const Metric metric : columns) {
    const TradeOffs all = trade_offs(pool, metric);
    const auto knee = pareto_knee(all.points);
    if (!knee) continue;
    std::string names;
    for (const std::size_t i : pareto_line(all.points)) {
      const PooledConfig& config = pool.configs[all.members[i]];
      names += fmt::format("{}{}{}", names.empty() ? "" : ", ", report.configs[config.config].name,
                           i == *knee ? " (knee)" : "");
    }
    text += fmt::format("  {:<12} {}\n", text_of(metric).key, names);
  }
  return text;
}

std::string price_table(std::size_t config, const ErrorReport& report) {
  const Price price = price_of(config, report);
  std::string text =
      heading(fmt::format("Price: time of \"{}\" over that of \"{}\"", report.configs[config].name,
                          report.configs[price.fastest].name));
  const auto row = [&](std::string_view name, const std::array<double, 3>& ratios) {
    text += fmt::format("  {:<10}", name);
    for (const double ratio : ratios) {
      text += ratio > 0.0 ? fmt::format(" {:>10.3f}", ratio) : fmt::format(" {:>10}", "-");
    }
    text += "\n";
  };
  text += fmt::format("  {:<10}", "");
  for (const RayGroup group : priced_groups) text += fmt::format(" {:>10}", name_of(group));
  text += "\n";
  for (std::size_t i = 0; i < price.ratios.size(); ++i) {
    row(report.scenes[i].name, price.ratios[i]);
  }
  row("median", price.medians);
  return text;
}

std::string aligned(const ImageTable& table) {
  std::vector<std::size_t> widths;
  for (const std::string& head : table.heads) widths.push_back(head.size());
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text =
      fmt::format("\n  {}{}{}\n", table.title, table.caption.empty() ? "" : ". ", table.caption);
  const auto add = [&](const std::vector<std::string>& row) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      text += fmt::format("{:>{}}", row[i], widths[i] + 2);
    }
    text += "\n";
  };
  add(table.heads);
  for (const auto& row : table.rows) add(row);
  return text;
}

std::string images_text(const ErrorStudy& study) {
  std::string text;
  for (const SceneImageError& image : study.images) {
    text += heading(fmt::format("Picture of {}: {}", image.scene, how_measured(image.params)));
    for (const ImageTable& table : image_tables(image)) text += aligned(table);
  }
  return text;
}

std::string introduction(const ErrorReport& report) {
  std::uint64_t rays = 0;
  for (const SceneErrors& scene : report.scenes) {
    for (const std::uint64_t count : scene.rays) rays += count;
  }
  std::string factors;
  for (const Factor factor : report.strongest_factors) {
    factors += fmt::format("{}{}", factors.empty() ? "" : ", ", name_of(factor));
  }
  return fmt::format(
      "{}, {}, {}, all judged; {}, {}\n"
      "strongest factors, measured in every combination: {}\n"
      "per million; \"< x\": none found, so fewer than x with 95 % certainty (3 / N)\n",
      counted(report.configs.size(), "configuration"), counted(report.scenes.size(), "scene"),
      counted(rays, "recorded ray"), counted(report.params.repeats, "interleaved repeat"),
      clock_text(report.params.timing_threads), factors);
}

std::string rays_text(const ErrorReport& report) {
  std::string text = introduction(report);
  if (const std::string sentence = embree_sentence(report); !sentence.empty())
    text += sentence + "\n";
  const ErrorPool all = pool_of_all(report);
  text += heading("Scenes: " + scene_names(report, all.scenes));
  text += pool_table(report, all, ordinary_columns);
  text += heading("Pareto fronts, from the fastest on") + fronts(report, all, ordinary_columns);
  if (const ErrorPool triangles = pool_of_triangles(report); !triangles.configs.empty()) {
    text += heading("Scenes of triangles only: " + scene_names(report, triangles.scenes));
    text += pool_table(report, triangles, triangle_columns);
    text += heading("Pareto fronts there") + fronts(report, triangles, triangle_columns);
  }
  return text + price_table(report.pictures_config, report) + price_table(default_config, report);
}

}  // namespace

std::string format_estimate(const std::optional<Estimate>& estimate) {
  if (!estimate) return "-";
  const double value = estimate->value;
  const std::string number =
      value >= 100.0 ? fmt::format("{:.0f}", value) : fmt::format("{:.2g}", value);
  return estimate->is_bound ? "< " + number : number;
}

std::string to_text(const ErrorStudy& study) {
  std::string text = study.rays.scenes.empty() ? "" : rays_text(study.rays);
  text += images_text(study) + "\n";
  for (const std::string& sentence : verdict(study)) text += sentence + "\n";
  return text;
}

}  // namespace bspview
