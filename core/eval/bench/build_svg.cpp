#include <fmt/format.h>

#include <cmath>

#include "core/eval/bench/build_run.h"
#include "core/eval/error/log_axis.h"
#include "core/eval/error/plot.h"

namespace bspview {
namespace {

// Pixels.
constexpr double width = 760.0, left = 60.0, right = 120.0, top = 78.0;
constexpr double panel_height = 230.0, panel_gap = 62.0, label_height = 12.0;

struct Line {
  std::size_t peer = 0;
  int threads = 1;
  std::vector<std::pair<double, double>> points;  // objects, microseconds an object
};

std::vector<Line> lines_of(const BuildReport& report, const BuildFamily& family) {
  std::vector<Line> lines;
  for (std::size_t peer = 0; peer < report.peers.size(); ++peer) {
    for (const int threads : report.threads) {
      Line line{peer, threads, {}};
      for (const BuiltScene& scene : family.sizes) {
        const BuildTimes* const times = find_times(scene, peer, threads);
        if (!times) continue;
        const auto objects = static_cast<double>(scene.objects);
        line.points.emplace_back(objects, 1e6 * summarise(times->seconds).median / objects);
      }
      if (!line.points.empty()) lines.push_back(std::move(line));
    }
  }
  return lines;
}

/// One panel a family: microseconds an object over the objects, both in logarithms.
class BuildChart {
 public:
  explicit BuildChart(const BuildReport& report) : report_(report) {
    std::vector<double> objects, times;
    for (const BuildFamily& family : report.families) {
      for (const Line& line : lines_of(report, family)) {
        for (const auto& [n, us] : line.points) {
          objects.push_back(n);
          times.push_back(us);
        }
      }
    }
    x_ = fit_axis(objects, left, width - right);
    y_ = fit_axis(times, panel_height, 24.0);
  }

  std::string svg() {
    for (const BuildFamily& family : report_.families) {
      if (!family.sizes.empty()) draw(family);
    }
    return head() + text_ + "</svg>\n";
  }

 private:
  std::string head() const {
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1:.0f}\" "
               "width=\"{0}\" height=\"{1:.0f}\">\n<style>\n"
               "svg{{font:12px system-ui,\"DejaVu Sans\",sans-serif}}.page{{fill:#fff}}\n"
               ".title{{font-size:16px;font-weight:600}}.panel{{font-weight:600}}\n"
               "text{{fill:#1c1c1e}}.unit{{fill:#6b6b70}}.grid{{stroke:#e4e4e8}}\n"
               ".line{{fill:none;stroke-width:2}}.own{{stroke:#0068a8}}.rival{{stroke:#c44e00}}\n"
               ".many{{stroke-dasharray:5 3}}.power{{font-size:9px}}\n"
               "@media (prefers-color-scheme:dark){{.page{{fill:#1c1c1e}}\n"
               "text{{fill:#f2f2f4}}.unit{{fill:#a0a0a6}}.grid{{stroke:#34343a}}\n"
               ".own{{stroke:#4da3dd}}.rival{{stroke:#e8803c}}}}\n</style>\n"
               "<rect class=\"page\" width=\"100%\" height=\"100%\"/>\n",
               width, y_offset_) +
           fmt::format(
               "<text class=\"title\" x=\"16\" y=\"26\">Time to build over the number of objects"
               "</text>\n<text class=\"unit\" x=\"16\" y=\"46\">microseconds an object; blue: "
               "bspview, orange: others; dashed: several threads; {}</text>\n",
               escape_markup(report_.machine.cpu));
  }

  void draw(const BuildFamily& family) {
    text_ += fmt::format("<text class=\"panel\" x=\"16\" y=\"{:.1f}\">{}</text>\n", y_offset_,
                         family.name);
    draw_axes();
    std::vector<double> labels;
    for (const Line& line : lines_of(report_, family)) {
      draw(line);
      label(line, labels);
    }
    y_offset_ += panel_height + panel_gap;
  }

  void draw_axes() {
    for (const Tick& tick : y_.ticks()) {
      const double y = y_offset_ + y_.place(tick.value);
      text_ += fmt::format(
          "<path class=\"grid\" d=\"M{:.1f} {:.1f}H{:.1f}\"/><text class=\"unit\" x=\"{:.1f}\" "
          "y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n",
          left, y, width - right, left - 8.0, y + 4.0, tick.text);
    }
    for (const Tick& tick : x_.ticks()) {
      text_ += fmt::format(
          "<text class=\"unit\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
          x_.place(tick.value), y_offset_ + panel_height + 18.0, tick.text);
    }
  }

  void draw(const Line& line) {
    std::string path;
    for (const auto& [objects, us] : line.points) {
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x_.place(objects),
                          y_offset_ + y_.place(us));
    }
    text_ +=
        fmt::format("<path class=\"line {}{}\" d=\"{}\"><title>{}, threads: {}</title></path>\n",
                    report_.peers[line.peer].foreign ? "rival" : "own",
                    line.threads > 1 ? " many" : "", path, name_of(line), line.threads);
  }

  void label(const Line& line, std::vector<double>& taken) {
    const double y = y_.place(line.points.back().second);
    for (const double other : taken) {
      if (std::abs(other - y) < label_height) return;
    }
    taken.push_back(y);
    text_ += fmt::format("<text class=\"unit\" x=\"{:.1f}\" y=\"{:.1f}\">{}{}</text>\n",
                         x_.place(line.points.back().first) + 6.0, y_offset_ + y + 4.0,
                         name_of(line), line.threads > 1 ? fmt::format(" x{}", line.threads) : "");
  }

  std::string name_of(const Line& line) const {
    return escape_markup(report_.peers[line.peer].name);
  }

  const BuildReport& report_;
  LogAxis x_, y_;
  double y_offset_ = top;
  std::string text_;
};

}  // namespace

std::string to_svg(const BuildReport& report) {
  return BuildChart(report).svg();
}

}  // namespace bspview
