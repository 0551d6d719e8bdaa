#include "core/eval/error/page.h"

#include <fmt/format.h>

#include <algorithm>

namespace bspview {
namespace {

std::string kind_of(const ErrorConfig& config) {
  if (!config.choice) return "foreign";
  switch (config.choice->faces) {
    case FaceTest::moeller_float:
      return "float";
    case FaceTest::woop_float:
      return "woop";
    case FaceTest::moeller_double:
      return "double";
    case FaceTest::exact:
      break;
  }
  return "exact";
}

PlotPoint mark(const ErrorConfig& config, const PooledConfig& measured, const Estimate& error) {
  PlotPoint point{.x = measured.ns, .y = error.value, .x_spread = measured.ns_mad};
  point.label = config.name;
  point.tip = fmt::format("{}: {:.1f} ± {:.1f} ns, {}\n{}", config.name, measured.ns,
                          measured.ns_mad, format_estimate(error), config.what);
  point.kind = kind_of(config);
  point.open = error.is_bound;
  return point;
}

std::string knee_sentence(const std::string& name, const PooledConfig& config,
                          const Estimate& error, std::string_view unit) {
  return fmt::format("Knee of the front: <b>{}</b>, {:.0f} ns per ray, {} {}.", escape_markup(name),
                     config.ns, escape_markup(format_estimate(error)), unit);
}

std::string cell(const std::string& text) {
  return "<td>" + escape_markup(text) + "</td>";
}

std::string ratio_row(const std::string& name, const std::array<double, 3>& ratios,
                      const std::string& row_class) {
  std::string html = fmt::format("<tr{}><td>{}</td>", row_class, escape_markup(name));
  for (const double ratio : ratios) html += cell(ratio > 0.0 ? fmt::format("{:.3f}", ratio) : "-");
  return html + "</tr>\n";
}

}  // namespace

std::string trade_off_figure(const ErrorReport& report, const ErrorPool& pool, Metric metric) {
  const TradeOffs all = trade_offs(pool, metric);
  const auto knee = pareto_knee(all.points);
  if (!knee) return "";
  Plot plot{.title = std::string(text_of(metric).title),
            .x_title = "ns per ray",
            .y_title = std::string(text_of(metric).unit),
            .points = {},
            .lines = {{{}, "front"}}};
  for (std::size_t i = 0; i < all.points.size(); ++i) {
    const PooledConfig& measured = pool.configs[all.members[i]];
    PlotPoint point = mark(report.configs[measured.config], measured, all.errors[i]);
    point.ringed = measured.config == report.pictures_config;
    point.strong = point.ringed || measured.config == fast_config ||
                   measured.config == default_config || point.kind == "foreign";
    plot.points.push_back(point);
  }
  for (const std::size_t i : pareto_line(all.points)) {
    plot.points[i].strong = true;
    plot.lines.front().points.emplace_back(all.points[i].time, all.errors[i].value);
  }
  plot.points[*knee].label += " (knee)";
  const PooledConfig& at_knee = pool.configs[all.members[*knee]];
  return "<figure>\n" + draw_plot(plot) + "<figcaption>" +
         knee_sentence(report.configs[at_knee.config].name, at_knee, all.errors[*knee],
                       text_of(metric).unit) +
         "</figcaption>\n</figure>\n";
}

std::string pool_table_html(const ErrorReport& report, const ErrorPool& pool,
                            std::span<const Metric> metrics) {
  std::string html =
      "<div class=\"wide\"><table>\n<tr><th>configuration</th><th>ns per ray</th>"
      "<th>MAD</th>";
  for (const Metric metric : metrics) {
    html += fmt::format("<th title=\"{}\">{}</th>", text_of(metric).unit, text_of(metric).title);
  }
  html += "</tr>\n";
  for (const PooledConfig& one : pool.configs) {
    const ErrorConfig& config = report.configs[one.config];
    html += fmt::format("<tr{}><td title=\"{}\">{}</td>",
                        one.config == report.pictures_config ? " class=\"own\"" : "",
                        escape_markup(config.what), escape_markup(config.name));
    html += cell(fmt::format("{:.1f}", one.ns)) + cell(fmt::format("{:.1f}", one.ns_mad));
    for (const Metric metric : metrics) {
      html += cell(format_estimate(estimate(one.counts, metric)));
    }
    html += "</tr>\n";
  }
  return html + "</table></div>\n";
}

std::string price_table_html(std::size_t config, const ErrorReport& report) {
  const Price price = price_of(config, report);
  std::string html = fmt::format(
      "<p>Time of <b>{}</b> over that of the fastest configuration in float with a published "
      "traversal, <b>{}</b>.</p>\n<table>\n<tr><th>scene</th>",
      escape_markup(report.configs[config].name),
      escape_markup(report.configs[price.fastest].name));
  for (const RayGroup group : priced_groups) html += fmt::format("<th>{}</th>", name_of(group));
  html += "</tr>\n";
  for (std::size_t i = 0; i < price.ratios.size(); ++i) {
    html += ratio_row(report.scenes[i].name, price.ratios[i], "");
  }
  return html + ratio_row("median", price.medians, " class=\"own\"") + "</table>\n";
}

}  // namespace bspview
