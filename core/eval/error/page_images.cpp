#include <fmt/format.h>

#include <algorithm>

#include "core/eval/error/page.h"

namespace bspview {
namespace {

/// Adaptive sampling stands out; cut-offs recede.
std::string kind_of(const ImageErrorCurve& curve) {
  if (curve.name == "uniform") return "exact";
  return curve.name == "adaptive" ? "float" : "woop";
}

std::string curve_figure(const SceneImageError& image, const std::string& title,
                         double ImageErrorPoint::*error) {
  Plot plot{.title = title,
            .x_title = "seconds to the picture",
            .y_title = "against a converged one",
            .points = {},
            .lines = {}};
  for (const ImageErrorCurve& curve : image.curves) {
    PlotLine line{{}, kind_of(curve)};
    for (const ImageErrorPoint& one : curve.points) {
      if (!(one.seconds.median > 0.0 && one.*error > 0.0)) continue;
      PlotPoint point{.x = one.seconds.median, .y = one.*error};
      point.tip = fmt::format("{}, {}: {:.4f} s, {:.3g}", curve.name, one.name, one.seconds.median,
                              one.*error);
      point.kind = line.kind;
      plot.points.push_back(point);
      line.points.emplace_back(point.x, point.y);
    }
    if (line.points.empty()) continue;
    plot.points.back().label = curve.name;
    plot.points.back().strong = true;
    plot.lines.push_back(std::move(line));
  }
  return "<figure>\n" + draw_plot(plot) + "</figure>\n";
}

std::string match_table(const ImageErrorCurve& curve, const ImageErrorCurve& base) {
  const std::vector<ImageErrorMatch> matches = match(curve, base);
  if (matches.empty()) return "";
  std::string html = fmt::format(
      "<table>\n<caption>{0} against {1}: what it saves at equal RMSE, its RMSE at equal time"
      "</caption>\n<tr><th>{0}</th><th>RMSE</th><th>samples a pixel</th><th>{1} needs</th>"
      "<th>samples saved</th><th>time saved</th><th>RMSE at equal time</th></tr>\n",
      escape_markup(curve.name), escape_markup(base.name));
  for (const ImageErrorMatch& one : matches) {
    html += fmt::format(
        "<tr><td>{}</td><td>{:.4f}</td><td>{:.1f}</td><td>{:.1f}</td>"
        "<td>{:.0f} %</td><td>{:.0f} %</td><td>x {:.2f}</td></tr>\n",
        escape_markup(one.name), one.rmse, one.samples, one.base_samples,
        100.0 * one.samples_saved(), 100.0 * one.seconds_saved(), one.rmse_ratio());
  }
  return html + "</table>\n";
}

}  // namespace

std::string image_section(const SceneImageError& image) {
  std::string html = fmt::format(
      "<h3>{}, {} x {} pixels, against {} samples a pixel</h3>\n<div class=\"plots\">\n",
      escape_markup(image.scene), image.params.render.width, image.params.render.height,
      image.params.reference_samples);
  html += curve_figure(image, "RMSE", &ImageErrorPoint::rmse);
  html += curve_figure(image, "relMSE", &ImageErrorPoint::rel_mse);
  html += "</div>\n";
  for (const ImageErrorCurve& curve : image.curves) {
    if (&curve != &image.curves.front()) html += match_table(curve, image.curves.front());
  }
  return html;
}

}  // namespace bspview
