#include "core/eval/error/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "core/eval/error/log_axis.h"

namespace bspview {
namespace {

// Pixels.
constexpr double width = 720.0, height = 430.0;
constexpr double left = 78.0, right = 20.0, top = 44.0, bottom = 62.0;
constexpr double radius = 4.5, letter_width = 6.1, line_height = 13.0;

struct Box {
  double x0, y0, x1, y1;
  bool overlaps(const Box& other) const {
    return x0 < other.x1 && other.x0 < x1 && y0 < other.y1 && other.y0 < y1;
  }
};

/// Where labels are anchored to their points.
struct Spot {
  double dx, dy;
  const char* anchor;
};
constexpr std::array<Spot, 12> spots{{{9, 4, "start"},
                                      {-9, 4, "end"},
                                      {0, -9, "middle"},
                                      {0, 19, "middle"},
                                      {8, -9, "start"},
                                      {8, 16, "start"},
                                      {-8, -9, "end"},
                                      {-8, 16, "end"},
                                      {0, -22, "middle"},
                                      {0, 32, "middle"},
                                      {14, -24, "start"},
                                      {14, 34, "start"}}};

Box label_box(const std::string& text, double x, double y, const Spot& spot) {
  const double length = letter_width * static_cast<double>(text.size());
  const std::string_view anchor(spot.anchor);
  const double shift = anchor == "start" ? 0.0 : anchor == "end" ? -length : -0.5 * length;
  const double x0 = x + spot.dx + shift, y1 = y + spot.dy + 3.0;
  return {x0 - 2.0, y1 - line_height, x0 + length + 2.0, y1};
}

/// Finds room for labels.
class Labels {
 public:
  void block(const Box& box) { taken_.push_back(box); }

  /// Blocks a line, with the dots that it is covered by.
  void block_line(double x0, double y0, double x1, double y1) {
    constexpr double step = 6.0, clear = 2.0;
    const int dots = 1 + static_cast<int>(std::hypot(x1 - x0, y1 - y0) / step);
    for (int i = 0; i <= dots; ++i) {
      const double x = std::lerp(x0, x1, i / double(dots)), y = std::lerp(y0, y1, i / double(dots));
      block({x - clear, y - clear, x + clear, y + clear});
    }
  }

  /// The first spot around (x, y) that is free, now taken; faint labels stand close to theirs.
  std::optional<Spot> find(const PlotPoint& point, double x, double y) {
    const std::string& text = point.label;
    for (const Spot& spot : std::span(spots).first(point.strong ? spots.size() : 4)) {
      const Box box = label_box(text, x, y, spot);
      const bool inside =
          box.x0 > left && box.x1 < width - 2.0 && box.y0 > top - 10.0 && box.y1 < height - bottom;
      if (!inside || std::ranges::any_of(taken_, [&](const Box& b) { return b.overlaps(box); })) {
        continue;
      }
      taken_.push_back(box);
      return spot;
    }
    return std::nullopt;
  }

 private:
  std::vector<Box> taken_;
};

/// The largest x that is drawn: what lies far beyond most points is not.
double largest_drawn(const Plot& plot) {
  std::vector<double> xs;
  for (const PlotPoint& point : plot.points) xs.push_back(point.x);
  if (xs.empty()) return 1.0;
  std::ranges::sort(xs);
  const double most = plot.farthest * xs[xs.size() / 2];
  return *std::prev(std::ranges::upper_bound(xs, most));
}

class Drawing {
 public:
  explicit Drawing(const Plot& plot) : plot_(plot), last_x_(largest_drawn(plot)) {
    std::vector<double> xs, ys;
    for (const PlotPoint& point : plot.points) {
      if (!is_drawn(point)) continue;
      xs.push_back(point.x);
      ys.push_back(point.y);
    }
    x_ = fit_axis(xs, left, width - right);
    y_ = fit_axis(ys, height - bottom, top);
    if (plot.whole_decades) y_ = whole_decades(y_);
  }

  std::string svg() {
    text_ = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n", width,
                        height, escape_markup(plot_.title));
    text_ += fmt::format("<text class=\"title\" x=\"{}\" y=\"18\">{}</text>\n", left,
                         escape_markup(plot_.title));
    draw_axes();
    for (const PlotLine& line : plot_.lines) draw_line(line);
    for (const PlotPoint& point : plot_.points) draw_point(point);
    draw_labels();
    draw_left_out();
    return text_ + "</svg>\n";
  }

 private:
  bool is_drawn(const PlotPoint& point) const { return point.x <= last_x_; }

  void draw_axes() {
    for (const Tick& tick : y_.ticks()) {
      const double y = y_.place(tick.value);
      text_ +=
          fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>", left, y, width - right);
      text_ += fmt::format(
          "<text class=\"tick\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}"
          "</text>\n",
          left - 8.0, y + 4.0, tick.text);
    }
    const double base = height - bottom;
    for (const Tick& tick : x_.ticks()) {
      const double x = x_.place(tick.value);
      text_ += fmt::format("<path class=\"axis\" d=\"M{:.1f} {:.1f}v5\"/>", x, base);
      text_ += fmt::format(
          "<text class=\"tick\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}"
          "</text>\n",
          x, base + 19.0, tick.text);
    }
    text_ += fmt::format("<path class=\"axis\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>\n", left, base,
                         width - right);
    text_ += fmt::format(
        "<text class=\"unit\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}"
        "</text>\n",
        width - right, base + 38.0, escape_markup(plot_.x_title));
    text_ += fmt::format("<text class=\"unit\" x=\"{:.1f}\" y=\"34\">{}</text>\n", left,
                         escape_markup(plot_.y_title));
  }

  void draw_line(const PlotLine& line) {
    std::string path;
    std::pair last(0.0, 0.0);
    for (const auto& [x, y] : line.points) {
      const std::pair next(x_.place(x), y_.place(y));
      if (!path.empty()) labels_.block_line(last.first, last.second, next.first, next.second);
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", next.first, next.second);
      last = next;
    }
    text_ += fmt::format("<path class=\"line {}\" d=\"{}\"/>\n", line.kind, path);
  }

  void draw_point(const PlotPoint& point) {
    if (!is_drawn(point)) return;
    const double x = x_.place(point.x), y = y_.place(point.y);
    labels_.block({x - radius - 1.0, y - radius - 1.0, x + radius + 1.0, y + radius + 1.0});
    if (point.ringed) {
      text_ += fmt::format("<circle class=\"ring {}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"8.5\"/>",
                           point.kind, x, y);
    }
    const double from = x_.place(std::max(x_.lo, point.x - point.x_spread));
    const double to = x_.place(std::min(x_.hi, point.x + point.x_spread));
    labels_.block_line(from, y, to, y);
    text_ += fmt::format("<path class=\"spread {}\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>", point.kind,
                         from, y, to);
    text_ += fmt::format(
        "<circle class=\"{} {}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"><title>{}"
        "</title></circle>\n",
        point.open ? "open" : "full", point.kind, x, y, radius, escape_markup(point.tip));
  }

  void draw_labels() {
    for (const bool strong : {true, false}) {
      for (const PlotPoint& point : plot_.points) {
        if (point.strong != strong || point.label.empty() || !is_drawn(point)) continue;
        const double x = x_.place(point.x), y = y_.place(point.y);
        const auto spot = labels_.find(point, x, y);
        if (!spot) continue;
        text_ += fmt::format(
            "<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}"
            "</text>\n",
            strong ? "label" : "label faint", x + spot->dx, y + spot->dy, spot->anchor,
            escape_markup(point.label));
      }
    }
  }

  /// The least and the largest x of what is not drawn.
  void draw_left_out() {
    double least = 0.0, most = 0.0;
    int count = 0;
    for (const PlotPoint& point : plot_.points) {
      if (is_drawn(point)) continue;
      least = count == 0 ? point.x : std::min(least, point.x);
      most = std::max(most, point.x);
      ++count;
    }
    if (count == 0) return;
    text_ += fmt::format(
        "<text class=\"unit\" x=\"{:.1f}\" y=\"{:.1f}\">{} more beyond the right "
        "edge, at {:.0f} to {:.0f}</text>\n",
        left, height - bottom + 38.0, count, least, most);
  }

  const Plot& plot_;
  double last_x_;
  LogAxis x_, y_;
  Labels labels_;
  std::string text_;
};

}  // namespace

std::string draw_plot(const Plot& plot) {
  return Drawing(plot).svg();
}

std::string escape_markup(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string plot_style() {
  // Hues after Okabe & Ito 2008, which stay apart for colour-blind readers.
  struct Hue {
    const char* kind;
    const char* light;
    const char* dark;
  };
  constexpr std::array<Hue, 6> hues{{{"float", "#c44e00", "#ff9b52"},
                                     {"woop", "#0068a8", "#6fbdf0"},
                                     {"double", "#00805c", "#4fd0a5"},
                                     {"exact", "#1c1c1e", "#f2f2f4"},
                                     {"foreign", "#a8427d", "#e79ac6"},
                                     {"quiet", "#8a8a90", "#8a8a90"}}};
  std::string light, dark;
  for (const auto& [kind, on_light, on_dark] : hues) {
    for (const auto& [style, colour] : {std::pair(&light, on_light), std::pair(&dark, on_dark)}) {
      *style += fmt::format(
          ".full.{0}{{fill:{1}}}.open.{0},.ring.{0},.spread.{0},.line.{0}"
          "{{stroke:{1}}}.key.{0}{{background:{1}}}\n",
          kind, colour);
    }
  }
  return "svg{font:12px system-ui,\"DejaVu "
         "Sans\",sans-serif;display:block;width:100%;height:auto}\n"
         ".title{font-size:15px;font-weight:600}.power{font-size:9px}\n"
         ".open,.ring,.line,.spread{fill:none;stroke-width:1.6}.spread{stroke-width:1}\n"
         ".ring{stroke-width:1.4}.line{stroke-width:1.3;stroke-linejoin:round}\n"
         ".line.front{stroke-dasharray:5 4}\n"
         ".grid{stroke-width:1;fill:none}.axis{stroke-width:1;fill:none}.label{font-size:11px;"
         "paint-order:stroke;stroke-width:3px;stroke-linejoin:round}\n"
         ".title,.label{fill:#1c1c1e}.label{stroke:#fff}.faint,.tick,.unit{fill:#6b6b70}.grid{"
         "stroke:#ececef}"
         ".axis,.line.front{stroke:#8a8a90}\n" +
         light +
         "@media (prefers-color-scheme:dark){\n"
         ".title,.label{fill:#f2f2f4}.label{stroke:#161618}.faint,.tick,.unit{fill:#a0a0a6}.grid{"
         "stroke:#2e2e33}"
         ".axis,.line.front{stroke:#77777d}\n" +
         dark + "}\n";
}

}  // namespace bspview
