#include "app/viewer/panels/trade_off_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "app/viewer/layout.h"
#include "app/viewer/panels/numbers.h"
#include "app/viewer/panels/widgets.h"
#include "core/eval/error/pareto.h"

namespace bspview {
namespace {

constexpr float chart_height = 150.0f, left_margin = 30.0f, bottom_margin = 30.0f;
constexpr float radius = 4.0f;

/// A logarithmic axis over part of the screen.
struct Axis {
  double lo, hi;   // values at its ends
  float from, to;  // their places
  float at(double value) const {
    const double share = std::log(value / lo) / std::log(hi / lo);
    return from + static_cast<float>(share) * (to - from);
  }
};

/// From a little below the least to a little more above the largest value.
template <class Value>
Axis make_axis(std::span<const TradeOffPoint> points, const Value& value, float from, float to) {
  double lo = value(points.front()), hi = lo;
  for (const TradeOffPoint& point : points) {
    lo = std::min(lo, value(point));
    hi = std::max(hi, value(point));
  }
  const double room = std::max(1.3, std::pow(hi / lo, 0.15));
  return {lo / room, hi * room * room, from, to};
}

class Chart {
 public:
  Chart(const Ui& ui, const Rect& rect, std::span<const TradeOffPoint> points)
      : ui_(ui),
        points_(points),
        plot_{rect.x + ui.px(left_margin), rect.y + ui.px(4), rect.width - ui.px(left_margin + 4),
              rect.height - ui.px(bottom_margin + 4)},
        x_(make_axis(points, time_of, plot_.x, plot_.right())),
        y_(make_axis(points, error_of, plot_.bottom(), plot_.y)) {}

  void draw_axes() const {
    const ImU32 line = ImGui::GetColorU32(ui_.palette.line);
    list_.AddRect({plot_.x, plot_.y}, {plot_.right(), plot_.bottom()}, line);
    float free_from = plot_.x;
    for (double tick = 1e-9; tick < 1e12; tick *= 10.0) {
      if (y_.lo < tick && tick < y_.hi) draw_row(tick);
      for (const double step : {1.0, 2.0, 3.0, 5.0, 7.0})
        if (x_.lo < step * tick && step * tick < x_.hi) draw_column(step * tick, free_from);
    }
    list_.AddText({plot_.x + ui_.px(4), plot_.y + ui_.px(1)}, dim(), y_title);
    const ImVec2 size = ImGui::CalcTextSize(x_title);
    list_.AddText({plot_.right() - size.x, plot_.bottom() + ui_.px(14)}, dim(), x_title);
  }

  /// Through the ways that none beats in both.
  void draw_front() const {
    std::vector<TradeOff> trades;
    for (const TradeOffPoint& point : points_)
      trades.push_back({time_of(point), 0.0, error_of(point)});
    std::vector<ImVec2> line;
    for (const std::size_t index : pareto_line(trades)) line.push_back(place(points_[index]));
    list_.AddPolyline(line.data(), static_cast<int>(line.size()), dim(), 0, ui_.px(1.5f));
  }

  void draw_point(const TradeOffPoint& point, bool marked) const {
    const ImVec2 at = place(point);
    const ImU32 color = ImGui::GetColorU32(marked ? ui_.palette.accent : ui_.palette.text);
    if (point.wrong > 0)
      list_.AddCircleFilled(at, ui_.px(radius), color);
    else
      list_.AddCircle(at, ui_.px(radius), color, 0, ui_.px(1.5f));
    if (marked) list_.AddCircle(at, ui_.px(2 * radius), color, 0, ui_.px(1.5f));
  }

  /// The point under the pointer; null when there is none.
  const TradeOffPoint* find_pointed() const {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const TradeOffPoint* best = nullptr;
    float nearest = ui_.px(2 * radius);
    for (const TradeOffPoint& point : points_) {
      const ImVec2 at = place(point);
      const float distance = std::hypot(at.x - mouse.x, at.y - mouse.y);
      if (distance < nearest) {
        nearest = distance;
        best = &point;
      }
    }
    return best;
  }

 private:
  static constexpr const char* x_title = "ns a ray";
  static constexpr const char* y_title = "wrong hits a million";

  static double time_of(const TradeOffPoint& point) { return point.nanoseconds; }
  static double error_of(const TradeOffPoint& point) { return point.wrong_a_million(); }
  ImVec2 place(const TradeOffPoint& point) const {
    return {x_.at(time_of(point)), y_.at(error_of(point))};
  }
  ImU32 dim() const { return ImGui::GetColorU32(ui_.palette.dim_text); }

  void draw_row(double tick) const {
    const float y = y_.at(tick);
    list_.AddLine({plot_.x, y}, {plot_.right(), y}, ImGui::GetColorU32(ui_.palette.line));
    const std::string text = fmt::format("1e{:.0f}", std::log10(tick));
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    list_.AddText({plot_.x - size.x - ui_.px(3), y - size.y / 2}, dim(), text.c_str());
  }
  /// `free_from`: where the last label ended.
  void draw_column(double tick, float& free_from) const {
    const float x = x_.at(tick);
    list_.AddLine({x, plot_.y}, {x, plot_.bottom()}, ImGui::GetColorU32(ui_.palette.line));
    const std::string text = significant(tick, 1);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    if (x - width / 2 < free_from || x + width / 2 > plot_.right()) return;
    list_.AddText({x - width / 2, plot_.bottom() + ui_.px(2)}, dim(), text.c_str());
    free_from = x + width / 2 + ui_.px(6);
  }

  const Ui& ui_;
  std::span<const TradeOffPoint> points_;
  Rect plot_;
  Axis x_, y_;
  ImDrawList& list_ = *ImGui::GetWindowDrawList();
};

std::string text_of(const TradeOffPoint& point) {
  const std::string rate =
      point.wrong > 0 ? fmt::format("{} a million", significant(point.wrong_a_million(), 3))
                      : fmt::format("below {} a million", significant(point.wrong_a_million(), 3));
  return fmt::format("{} arithmetic, {} traversal\n{} ns a ray\n{} of {} rays wrong: {}",
                     name_of(point.arithmetic), name_of(point.traversal),
                     significant(point.nanoseconds, 3), point.wrong, point.rays, rate);
}

}  // namespace

void trade_off_chart(const Ui& ui, std::span<const TradeOffPoint> points, const ChartMark& mark) {
  if (points.empty()) return;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const Rect rect{corner.x, corner.y, ImGui::GetContentRegionAvail().x, ui.px(chart_height)};
  if (rect.width < ui.px(80)) return;
  ImGui::InvisibleButton("chart", {rect.width, rect.height});
  ui.note("accuracy.chart");
  const Chart chart(ui, rect, points);
  chart.draw_axes();
  chart.draw_front();
  for (const TradeOffPoint& point : points)
    chart.draw_point(point,
                     point.arithmetic == mark.arithmetic && point.traversal == mark.traversal);
  const TradeOffPoint* pointed = ImGui::IsItemHovered() ? chart.find_pointed() : nullptr;
  tooltip(ui,
          pointed != nullptr
              ? text_of(*pointed)
              : "Every arithmetic with every traversal on eye rays of this view. Upwards: wrong "
                "hits a million. Open circles: none was found, the rate is below (95 %). The "
                "line joins the ways that none beats in both. The "
                "ring marks the present setting. Point at a circle.");
}

}  // namespace bspview
