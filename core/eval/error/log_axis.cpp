#include "core/eval/error/log_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bspview {
namespace {

/// `factor` times the power of ten.
std::string power_text(int factor, int power) {
  if (power >= -3 && power <= 3) return fmt::format("{:g}", factor * std::pow(10.0, power));
  const std::string times = factor == 1 ? "" : fmt::format("{} × ", factor);
  return fmt::format("{}10<tspan dy=\"-5\" class=\"power\">{}</tspan>", times, power);
}

/// Powers of ten; on a short axis their doubles and fivefolds, too.
std::vector<Tick> powers(double lo, double hi) {
  const int first = static_cast<int>(std::floor(std::log10(lo) + 1e-9));
  const int last = static_cast<int>(std::floor(std::log10(hi) + 1e-9));
  const int step = std::max(1, (last - first + 7) / 8);
  const bool is_short = hi / lo < 2e3;
  std::vector<Tick> ticks;
  for (int power = first; power <= last; ++power) {
    const bool is_named = ((power % step) + step) % step == 0;
    for (const int factor : {1, 2, 5}) {
      const double value = factor * std::pow(10.0, power);
      if (value < lo * (1.0 - 1e-9) || value > hi * (1.0 + 1e-9)) continue;
      if (factor == 1 || is_short)
        ticks.push_back({value, is_named ? power_text(factor, power) : ""});
    }
  }
  return ticks;
}

/// The roundest step that makes at most ten ticks.
double even_step(double lo, double hi) {
  double unit = std::pow(10.0, std::floor(std::log10(hi - lo)) - 1.0);
  for (;; unit *= 10.0) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      if ((hi - lo) / (unit * factor) <= 9.0) return unit * factor;
    }
  }
}

}  // namespace

double LogAxis::place(double value) const {
  return std::lerp(from, to, std::log(value / lo) / std::log(hi / lo));
}

std::vector<Tick> LogAxis::ticks() const {
  if (hi / lo > 9.9) return powers(lo, hi);
  const double step = even_step(lo, hi);
  std::vector<Tick> ticks;
  for (double i = std::ceil(lo / step - 1e-9); i * step <= hi * (1.0 + 1e-12); ++i) {
    ticks.push_back({i * step, fmt::format("{:g}", i * step)});
  }
  return ticks;
}

LogAxis whole_decades(LogAxis axis) {
  axis.lo = std::pow(10.0, std::floor(std::log10(axis.lo)));
  axis.hi = std::pow(10.0, std::ceil(std::log10(axis.hi)));
  return axis;
}

LogAxis fit_axis(const std::vector<double>& values, double from, double to) {
  LogAxis axis{.from = from, .to = to};
  if (values.empty()) return axis;
  const auto [least, most] = std::ranges::minmax(values);
  const double room = std::max(std::pow(most / least, 0.06), 1.04);
  axis.lo = least / room;
  axis.hi = most * room;
  return axis;
}

}  // namespace bspview
