#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "core/eval/error/image_tables.h"
#include "core/eval/error/page.h"

namespace bspview {
namespace {

/// Hues of plot_style, one a curve.
std::string kind_of(const SceneImageError& image, const ImageErrorCurve& curve) {
  constexpr std::array kinds{"exact", "float", "woop", "double", "foreign", "quiet"};
  const auto number = static_cast<std::size_t>(&curve - image.curves.data());
  return kinds[std::min(number, kinds.size() - 1)];
}

std::string keys(const SceneImageError& image) {
  std::string html = "<p class=\"keys\">";
  for (const ImageErrorCurve& curve : image.curves) {
    html += fmt::format("<span><i class=\"key {}\"></i>{}</span>", kind_of(image, curve),
                        escape_markup(curve.name));
  }
  return html + "</p>\n";
}

/// A mark of a curve; nothing where it has no place in the plot.
using Marks = std::function<std::vector<PlotPoint>(const ImageErrorCurve&)>;

std::string figure(const SceneImageError& image, Plot plot, const Marks& marks) {
  plot.farthest = std::numeric_limits<double>::infinity();
  plot.whole_decades = false;
  for (const ImageErrorCurve& curve : image.curves) {
    PlotLine line{{}, kind_of(image, curve)};
    for (PlotPoint& point : marks(curve)) {
      if (!(point.x > 0.0 && point.y > 0.0)) continue;
      point.kind = line.kind;
      line.points.emplace_back(point.x, point.y);
      plot.points.push_back(std::move(point));
    }
    if (line.points.empty()) continue;
    plot.points.back().label = curve.name;
    plot.points.back().strong = true;
    plot.lines.push_back(std::move(line));
  }
  return plot.points.empty() ? "" : "<figure>\n" + draw_plot(plot) + "</figure>\n";
}

std::string error_figure(const SceneImageError& image, const std::string& title,
                         double ImageErrorPoint::*error) {
  Plot plot{.title = title,
            .x_title = "seconds to the picture",
            .y_title = fmt::format("against {} samples a pixel", image.params.reference_samples)};
  return figure(image, plot, [&](const ImageErrorCurve& curve) {
    std::vector<PlotPoint> marks;
    for (const ImageErrorPoint& one : curve.points) {
      PlotPoint& mark = marks.emplace_back(one.seconds.median, one.*error, one.seconds.spread);
      mark.tip = fmt::format("{}, {}: {:.4f} ± {:.4f} s, {:.3g}", curve.name, one.name,
                             one.seconds.median, one.seconds.spread, one.*error);
    }
    return marks;
  });
}

/// What a curve is compared with stands at 1.
std::string match_figure(const SceneImageError& image, Plot plot,
                         const std::function<PlotPoint(const ImageErrorMatch&)>& mark) {
  const ImageErrorCurve& base = image.curves.front();
  return figure(image, std::move(plot), [&](const ImageErrorCurve& curve) {
    std::vector<PlotPoint> marks;
    for (const ImageErrorPoint& point : curve.points) {
      const auto against = match(point, base);
      if (!against) continue;
      marks.push_back(mark(*against));
      marks.back().tip = fmt::format("{}, {}: {:.3f}", curve.name, point.name, marks.back().y);
    }
    return marks;
  });
}

std::string equal_time_figure(const SceneImageError& image) {
  return match_figure(image,
                      {.title = "RMSE at equal time",
                       .x_title = "seconds to the picture",
                       .y_title = "over that of uniform sampling; less than 1 is better"},
                      [](const ImageErrorMatch& match) {
                        return PlotPoint{.x = match.seconds, .y = match.rmse_ratio()};
                      });
}

std::string equal_error_figure(const SceneImageError& image) {
  return match_figure(image,
                      {.title = "Samples at equal RMSE",
                       .x_title = "samples a pixel that uniform sampling takes to the same RMSE",
                       .y_title = "over those of uniform sampling; less than 1 is better"},
                      [](const ImageErrorMatch& match) {
                        return PlotPoint{.x = match.base_samples,
                                         .y = match.samples / match.base_samples};
                      });
}

std::string table_html(const ImageTable& table) {
  const auto row = [](const std::vector<std::string>& cells, const char* tag) {
    std::string html = "<tr>";
    for (const std::string& cell : cells) {
      html += fmt::format("<{0}>{1}</{0}>", tag, escape_markup(cell));
    }
    return html + "</tr>\n";
  };
  std::string html = fmt::format("<h4>{}</h4>\n<p class=\"quiet\">{}</p>\n",
                                 escape_markup(table.title), escape_markup(table.caption));
  html += "<div class=\"wide\"><table>\n" + row(table.heads, "th");
  for (const auto& cells : table.rows) html += row(cells, "td");
  return html + "</table></div>\n";
}

}  // namespace

std::string image_section(const SceneImageError& image) {
  if (image.curves.empty()) return "";
  std::string html = fmt::format("<h3>{}</h3>\n<p class=\"quiet\">{}.</p>\n",
                                 escape_markup(image.scene), how_measured(image.params));
  html += keys(image) + "<div class=\"plots\">\n";
  html += error_figure(image, "RMSE", &ImageErrorPoint::rmse);
  html += error_figure(image, "relMSE", &ImageErrorPoint::rel_mse);
  html += equal_time_figure(image) + equal_error_figure(image) + "</div>\n";
  for (const ImageTable& table : image_tables(image)) html += table_html(table);
  return html;
}

}  // namespace bspview
