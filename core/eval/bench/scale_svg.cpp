#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/eval/bench/scale.h"
#include "core/eval/bench/summary.h"
#include "core/eval/error/log_axis.h"
#include "core/eval/error/plot.h"

namespace bspview {
namespace {

// Pixels.
constexpr double width = 760.0, left = 58.0, top = 66.0;
constexpr double panel_width = 188.0, panel_height = 120.0;
constexpr double column_width = 242.0, row_height = 168.0;
constexpr double legend_width = 182.0, legend_height = 20.0;
constexpr std::size_t legend_columns = 4;

struct Line {
  std::size_t peer = 0;
  std::vector<std::pair<double, double>> points;  // objects, ns
};

std::vector<Line> lines_of(const ScaleReport& report, const ScaleFamily& family, BenchKind kind) {
  std::vector<Line> lines;
  for (std::size_t peer = 0; peer < report.peers.size(); ++peer) {
    Line line{peer, {}};
    for (const SceneTimes& scene : family.sizes) {
      const KindTimes* const times = find_kind(scene, kind);
      if (!times) continue;
      line.points.emplace_back(static_cast<double>(scene.objects.objects),
                               summarise(times->peers[peer].nanoseconds).median);
    }
    if (!line.points.empty()) lines.push_back(std::move(line));
  }
  return lines;
}

/// A round distance of about four ticks from 0 to `most`.
double tick_step(double most) {
  const double least = most / 5.0;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) return factor * power;
  }
  return 10.0 * power;
}

/// A small panel for every standard scene and kind of rays: ns over the logarithm of the objects, a
/// line a peer.
class ScaleChart {
 public:
  explicit ScaleChart(const ScaleReport& report) : report_(report) {
    std::vector<double> objects;
    for (const ScaleFamily& family : report.families) {
      for (const SceneTimes& scene : family.sizes) {
        objects.push_back(static_cast<double>(scene.objects.objects));
      }
    }
    if (!objects.empty()) x_ = fit_axis(objects, 0.0, panel_width);
  }

  std::string svg() {
    draw_legend();
    const auto& kinds = report_.params.bench.kinds;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      text_ += fmt::format("<text class=\"panel\" x=\"{:.1f}\" y=\"{:.1f}\">{} rays</text>\n",
                           column(i), y_, name_of(kinds[i]));
    }
    y_ += 26.0;
    for (const ScaleFamily& family : report_.families) {
      text_ +=
          fmt::format("<text class=\"panel\" x=\"16\" y=\"{:.1f}\">{}</text>\n", y_, family.name);
      for (std::size_t i = 0; i < kinds.size(); ++i) draw(family, kinds[i], column(i));
      y_ += row_height;
    }
    return head() + text_ + "</svg>\n";
  }

 private:
  static double column(std::size_t i) { return left + column_width * static_cast<double>(i); }

  std::string head() const {
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1:.0f}\" "
               "width=\"{0}\" height=\"{1:.0f}\">\n<style>\n"
               "svg{{font:12px system-ui,\"DejaVu Sans\",sans-serif}}.page{{fill:#fff}}\n"
               ".title{{font-size:16px;font-weight:600}}.panel{{font-weight:600}}\n"
               "text{{fill:#1c1c1e}}.unit{{fill:#6b6b70}}.grid{{stroke:#e4e4e8}}\n"
               ".power{{font-size:9px}}.line{{fill:none;stroke-width:2}}\n"
               ".own0{{stroke:#0068a8}}.own1{{stroke:#00876c}}.own2{{stroke:#7a4fb5}}\n"
               ".rival0{{stroke:#c44e00}}.rival1{{stroke:#a3195b}}.rival2{{stroke:#7d6b00}}\n"
               ".own1,.rival1{{stroke-dasharray:7 3}}.own2,.rival2{{stroke-dasharray:2 3}}\n"
               "@media (prefers-color-scheme:dark){{.page{{fill:#1c1c1e}}\n"
               "text{{fill:#f2f2f4}}.unit{{fill:#a0a0a6}}.grid{{stroke:#34343a}}\n"
               ".own0{{stroke:#4da3dd}}.own1{{stroke:#3fbf9f}}.own2{{stroke:#b08fe0}}\n"
               ".rival0{{stroke:#e8803c}}.rival1{{stroke:#e26a9f}}.rival2{{stroke:#c9b23a}}}}\n"
               "</style>\n<rect class=\"page\" width=\"100%\" height=\"100%\"/>\n",
               width, y_) +
           fmt::format(
               "<text class=\"title\" x=\"16\" y=\"26\">Time of a ray over the number of objects"
               "</text>\n<text class=\"unit\" x=\"16\" y=\"46\">ns; one thread, {}</text>\n",
               escape_markup(report_.machine.cpu));
  }

  void draw_legend() {
    for (std::size_t peer = 0; peer < report_.peers.size(); ++peer) {
      const double x = 16.0 + legend_width * static_cast<double>(peer % legend_columns);
      const double y = y_ + legend_height * static_cast<double>(peer / legend_columns);
      text_ += fmt::format(
          "<path class=\"line {}\" d=\"M{:.1f} {:.1f}h28\"/><text x=\"{:.1f}\" y=\"{:.1f}\">{}"
          "</text>\n",
          style_of(peer), x, y, x + 36.0, y + 4.0, escape_markup(report_.peers[peer].name));
    }
    const std::size_t rows = (report_.peers.size() + legend_columns - 1) / legend_columns;
    y_ += legend_height * static_cast<double>(rows) + 14.0;
  }

  /// Ours and foreign ones have three styles each.
  std::string style_of(std::size_t peer) const {
    const bool foreign = report_.peers[peer].foreign;
    std::size_t before = 0;
    for (std::size_t i = 0; i < peer; ++i) before += report_.peers[i].foreign == foreign ? 1 : 0;
    return fmt::format("{}{}", foreign ? "rival" : "own", before % 3);
  }

  void draw(const ScaleFamily& family, BenchKind kind, double x) {
    const std::vector<Line> lines = lines_of(report_, family, kind);
    double slowest = 1.0;
    for (const Line& line : lines) {
      for (const auto& [objects, ns] : line.points) slowest = std::max(slowest, ns);
    }
    const double scale = (panel_height - 16.0) / slowest, base = y_ + panel_height;
    draw_axes(x, slowest);
    for (const Line& line : lines) {
      std::string path;
      for (const auto& [objects, ns] : line.points) {
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x + x_.place(objects),
                            base - scale * ns);
      }
      text_ += fmt::format("<path class=\"line {}\" d=\"{}\"><title>{}, {}</title></path>\n",
                           style_of(line.peer), path, family.name,
                           escape_markup(report_.peers[line.peer].name));
    }
  }

  void draw_axes(double x, double slowest) {
    const double scale = (panel_height - 16.0) / slowest, base = y_ + panel_height;
    const double step = tick_step(slowest);
    for (double ns = 0.0; ns <= slowest; ns += step) {
      const double y = base - scale * ns;
      text_ += fmt::format(
          "<path class=\"grid\" d=\"M{:.1f} {:.1f}h{:.1f}\"/><text class=\"unit\" x=\"{:.1f}\" "
          "y=\"{:.1f}\" text-anchor=\"end\">{:g}</text>\n",
          x, y, panel_width, x - 6.0, y + 4.0, ns);
    }
    for (const Tick& tick : x_.ticks()) {
      text_ += fmt::format(
          "<text class=\"unit\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
          x + x_.place(tick.value), base + 18.0, tick.text);
    }
  }

  const ScaleReport& report_;
  LogAxis x_;
  double y_ = top;
  std::string text_;
};

}  // namespace

std::string to_svg(const ScaleReport& report) {
  return ScaleChart(report).svg();
}

}  // namespace bspview
