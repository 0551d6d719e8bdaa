#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/base/counted.h"
#include "core/eval/bench/report.h"
#include "core/eval/bench/summary.h"
#include "core/eval/error/plot.h"

namespace bspview {
namespace {

// Pixels.
constexpr double width = 760.0, left = 190.0, right = 70.0, top = 62.0;
constexpr double bar_height = 16.0, row_height = 24.0, panel_gap = 58.0;

/// Bars of one kind of rays over some scenes.
struct Panel {
  std::string title;
  std::span<const SceneTimes> scenes;
  BenchKind kind = BenchKind::primary;
};

struct Bar {
  std::string name, tip;
  const char* style;
  double mean = 0.0;
  std::vector<std::pair<double, std::string>> marks;  // ratio and name of every scene
};

const char* style_of(const Peer& peer) {
  if (peer.foreign) return peer.answers == Peer::Answers::robust ? "rival" : "rival rough";
  return peer.answers == Peer::Answers::robust ? "own" : "own rough";
}

std::vector<Bar> bars_of(const BenchReport& report, const Panel& panel) {
  std::vector<Bar> bars;
  for (std::size_t i = 0; i < report.peers.size(); ++i) {
    const auto mean = mean_ratio(report, panel.scenes, panel.kind, i);
    if (!mean) continue;
    const Peer& peer = report.peers[i];
    Bar bar{peer.name, peer.what, style_of(peer), *mean, {}};
    for (const SceneTimes& scene : panel.scenes) {
      const KindTimes* const times = find_kind(scene, panel.kind);
      if (!times) continue;
      bar.marks.emplace_back(speed_ratio(*times, i, baseline(report)).median, scene.name);
    }
    bars.push_back(std::move(bar));
  }
  return bars;
}

class BarChart {
 public:
  explicit BarChart(const BenchReport& report) : report_(report) {
    for (const auto& [scenes, where] :
         {std::pair(&report.triangles, "triangles"), std::pair(&report.shapes, "round shapes")}) {
      if (scenes->empty()) continue;
      for (const BenchKind kind : report.params.kinds) {
        add({fmt::format("{} rays, {} of {}", name_of(kind), counted(scenes->size(), "scene"),
                         where),
             *scenes, kind});
      }
    }
  }

  std::string svg() {
    for (const auto& [title, bars] : panels_) {
      for (const Bar& bar : bars) {
        most_ = std::max(most_, bar.mean);
        for (const auto& [ratio, scene] : bar.marks) most_ = std::max(most_, ratio);
      }
    }
    most_ *= 1.02;
    for (const auto& [title, bars] : panels_) draw_panel(title, bars);
    return head() + text_ + "</svg>\n";
  }

 private:
  void add(const Panel& panel) {
    std::vector<Bar> bars = bars_of(report_, panel);
    if (!bars.empty()) panels_.emplace_back(panel.title, std::move(bars));
  }

  double place(double ratio) const { return left + (width - left - right) * ratio / most_; }

  std::string head() const {
    const std::string base = escape_markup(report_.peers[baseline(report_)].name);
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1:.0f}\" "
               "width=\"{0}\" height=\"{1:.0f}\">\n"
               "<style>\n"
               "svg{{font:12px system-ui,\"DejaVu Sans\",sans-serif}}\n"
               ".title{{font-size:16px;font-weight:600}}.panel{{font-weight:600}}\n"
               "text{{fill:#1c1c1e}}.unit{{fill:#6b6b70}}.line{{stroke:#8a8a90}}\n"
               ".page{{fill:#fff}}.own{{fill:#0068a8}}.rival{{fill:#c44e00}}.rough{{opacity:.5}}\n"
               ".mark{{fill:none;stroke:#1c1c1e;stroke-opacity:.55}}\n"
               "@media (prefers-color-scheme:dark){{\n"
               ".page{{fill:#1c1c1e}}text{{fill:#f2f2f4}}.unit{{fill:#a0a0a6}}\n"
               ".own{{fill:#4da3dd}}.rival{{fill:#e8803c}}.mark{{stroke:#f2f2f4}}}}\n"
               "</style>\n<rect class=\"page\" width=\"100%\" height=\"100%\"/>\n",
               width, y_) +
           fmt::format(
               "<text class=\"title\" x=\"16\" y=\"26\">Speed of tracing rays, {} = 1</text>\n"
               "<text class=\"unit\" x=\"16\" y=\"46\">bars: geometric mean; circles: the scenes; "
               "pale: not robust; one thread, {}</text>\n",
               base, escape_markup(report_.machine.cpu));
  }

  void draw_panel(const std::string& title, const std::vector<Bar>& bars) {
    const double first = y_ + 12.0;
    text_ += fmt::format("<text class=\"panel\" x=\"16\" y=\"{:.1f}\">{}</text>\n", y_,
                         escape_markup(title));
    for (std::size_t i = 0; i < bars.size(); ++i) {
      draw_bar(bars[i], first + row_height * static_cast<double>(i));
    }
    const double last = first + row_height * static_cast<double>(bars.size());
    text_ += fmt::format("<path class=\"line\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>\n", place(1.0),
                         first - 4.0, last - 4.0);
    y_ = last + panel_gap - row_height;
  }

  void draw_bar(const Bar& bar, double y) {
    const double middle = y + 0.5 * bar_height;
    text_ += fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>"
        "<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\">"
        "<title>{}</title></rect>\n",
        left - 8.0, middle + 4.0, escape_markup(bar.name), bar.style, left, y,
        place(bar.mean) - left, bar_height, escape_markup(bar.tip));
    for (const auto& [ratio, scene] : bar.marks) {
      text_ += fmt::format(
          "<circle class=\"mark\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\">"
          "<title>{}: {:.2f}</title></circle>\n",
          place(ratio), middle, escape_markup(scene), ratio);
    }
    text_ += fmt::format("<text class=\"panel\" x=\"{:.1f}\" y=\"{:.1f}\">{:.2f}</text>\n",
                         width - right + 12.0, middle + 4.0, bar.mean);
  }

  const BenchReport& report_;
  std::vector<std::pair<std::string, std::vector<Bar>>> panels_;
  double most_ = 1.0;  // the greatest ratio
  double y_ = top + 16.0;
  std::string text_;
};

}  // namespace

std::string to_svg(const BenchReport& report) {
  return BarChart(report).svg();
}

}  // namespace bspview
