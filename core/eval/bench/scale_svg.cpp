#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/eval/bench/scale.h"
#include "core/eval/bench/summary.h"
#include "core/eval/error/plot.h"

namespace bspview {
namespace {

// Pixels.
constexpr double width = 760.0, left = 60.0, right = 90.0, top = 62.0;
constexpr double panel_height = 260.0, panel_gap = 62.0, label_height = 12.0;

struct Place {
  double x, y;
};

/// Lines of one kind of rays: ns over the logarithm of the objects, one a family and peer.
class ScaleChart {
 public:
  explicit ScaleChart(const ScaleReport& report) : report_(report) {
    for (const ScaleFamily& family : report.families) {
      for (const SceneTimes& scene : family.sizes) {
        const auto objects = static_cast<double>(scene.objects.objects);
        least_ = std::min(least_, objects);
        most_ = std::max(most_, objects);
      }
    }
  }

  std::string svg() {
    std::string panels;
    for (const BenchKind kind : report_.params.bench.kinds) panels += panel(kind);
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1:.0f}\" "
               "width=\"{0}\" height=\"{1:.0f}\">\n<style>\n"
               "svg{{font:12px system-ui,\"DejaVu Sans\",sans-serif}}.page{{fill:#fff}}\n"
               ".title{{font-size:16px;font-weight:600}}.panel{{font-weight:600}}\n"
               "text{{fill:#1c1c1e}}.unit{{fill:#6b6b70}}.grid{{stroke:#e4e4e8}}\n"
               ".line{{fill:none;stroke-width:2}}.own{{stroke:#0068a8}}.rival{{stroke:#c44e00}}\n"
               "@media (prefers-color-scheme:dark){{.page{{fill:#1c1c1e}}\n"
               "text{{fill:#f2f2f4}}.unit{{fill:#a0a0a6}}.grid{{stroke:#34343a}}\n"
               ".own{{stroke:#4da3dd}}.rival{{stroke:#e8803c}}}}\n</style>\n"
               "<rect class=\"page\" width=\"100%\" height=\"100%\"/>\n",
               width, y_) +
           fmt::format(
               "<text class=\"title\" x=\"16\" y=\"26\">Time of a ray over the number of objects"
               "</text>\n<text class=\"unit\" x=\"16\" y=\"46\">ns; blue: bspview, orange: others; "
               "one thread, {}</text>\n",
               escape_markup(report_.machine.cpu)) +
           panels + "</svg>\n";
  }

 private:
  std::string panel(BenchKind kind) {
    double slowest = 1.0;
    for_each_line(kind, [&](const std::string&, std::size_t, const std::vector<Place>& line) {
      for (const Place& point : line) slowest = std::max(slowest, point.y);
    });
    const double base = y_ + panel_height;
    const auto place = [&](const Place& point) {
      const double share = std::log(point.x / least_) / std::log(std::max(2.0, most_ / least_));
      return Place{left + (width - left - right) * share,
                   base - (panel_height - 24.0) * point.y / slowest};
    };
    std::string text = fmt::format("<text class=\"panel\" x=\"16\" y=\"{:.1f}\">{} rays</text>\n",
                                   y_, name_of(kind));
    text += axes(place, slowest, base);
    std::vector<double> labels;
    for_each_line(
        kind, [&](const std::string& name, std::size_t peer, const std::vector<Place>& line) {
          std::string path;
          for (const Place& point : line) {
            const Place at = place(point);
            path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", at.x, at.y);
          }
          text += fmt::format("<path class=\"line {}\" d=\"{}\"><title>{}, {}</title></path>\n",
                              report_.peers[peer].foreign ? "rival" : "own", path, name,
                              escape_markup(report_.peers[peer].name));
          const Place end = place(line.back());
          const bool is_free = std::ranges::none_of(
              labels, [&](double y) { return std::abs(y - end.y) < label_height; });
          if (!is_free) return;
          labels.push_back(end.y);
          text += fmt::format("<text class=\"unit\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
                              end.x + 6.0, end.y + 4.0, name);
        });
    y_ = base + panel_gap;
    return text;
  }

  template <class PlaceOf>
  std::string axes(const PlaceOf& place, double slowest, double base) const {
    std::string text;
    const double step = std::pow(10.0, std::floor(std::log10(slowest)));
    for (double ns = 0.0; ns <= slowest; ns += slowest < 3.0 * step ? 0.5 * step : step) {
      const double y = place({least_, ns}).y;
      text +=
          fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>", left, y, width - right);
      text += fmt::format(
          "<text class=\"unit\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{:g}</text>\n",
          left - 8.0, y + 4.0, ns);
    }
    for (double objects = 1e3; objects <= most_; objects *= 10.0) {
      text += fmt::format(
          "<text class=\"unit\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
          place({objects, 0.0}).x, base + 18.0, static_cast<long>(objects));
    }
    return text;
  }

  /// Calls visit(family, peer, points (objects, ns)) for every line.
  template <class Visit>
  void for_each_line(BenchKind kind, const Visit& visit) const {
    for (const ScaleFamily& family : report_.families) {
      for (std::size_t i = 0; i < report_.peers.size(); ++i) {
        std::vector<Place> line;
        for (const SceneTimes& scene : family.sizes) {
          const KindTimes* const times = find_kind(scene, kind);
          if (!times) continue;
          line.push_back({static_cast<double>(scene.objects.objects),
                          summarise(times->peers[i].nanoseconds).median});
        }
        if (!line.empty()) visit(family.name, i, line);
      }
    }
  }

  const ScaleReport& report_;
  double least_ = 1e3, most_ = 1e3;  // objects
  double y_ = top + 16.0;
};

}  // namespace

std::string to_svg(const ScaleReport& report) {
  return ScaleChart(report).svg();
}

}  // namespace bspview
