#include "app/viewer/panels/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace bspview {
namespace {

constexpr double factor_from = 2.0;   // changes are written as a factor from here on
constexpr double equal_below = 5e-5;  // a relative change that "+0.0 %" would hide

}  // namespace

std::string with_thousands(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<std::size_t>(at), "\u00a0");
  return digits;
}

std::string significant(double value, int digits) {
  if (value == 0.0 || !std::isfinite(value)) return fmt::format("{}", value);
  const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
  return fmt::format("{:.{}f}", value, std::clamp(digits - 1 - magnitude, 0, 12));
}

std::string duration(double seconds) {
  if (seconds < 1e-3) return significant(1e6 * seconds, 3) + " µs";
  if (seconds < 1.0) return significant(1e3 * seconds, 3) + " ms";
  if (seconds < 60.0) return significant(seconds, 3) + " s";
  const int whole = static_cast<int>(std::lround(seconds));
  return fmt::format("{} min {} s", whole / 60, whole % 60);
}

std::string memory(double bytes) {
  constexpr std::array units{"B", "KiB", "MiB", "GiB", "TiB"};
  std::size_t unit = 0;
  for (; bytes >= 1000.0 && unit + 1 < units.size(); ++unit) bytes /= 1024.0;
  return fmt::format("{} {}", significant(bytes, 3), units[unit]);
}

std::string point(Vec3 p) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", p.x, p.y, p.z);
}

std::string counted(std::uint64_t number, const char* singular, const char* plural) {
  return with_thousands(number) + " " + (number == 1 ? singular : plural);
}

std::string change(double before, double now) {
  if (now == before) return "=";
  if (before == 0.0 || now == 0.0) return now > before ? "↑" : "↓";
  const double factor = now / before;
  if (factor >= factor_from) return "×" + significant(factor, 3);
  const double relative = factor - 1.0;
  if (std::abs(relative) < equal_below) return "≈";
  const char* sign = relative < 0 ? "−" : "+";
  const double percent = std::abs(100.0 * relative);
  const int decimals = percent >= 10.0 ? 0 : percent >= 1.0 ? 1 : 2;
  return fmt::format("{}{:.{}f} %", sign, percent, decimals);
}

}  // namespace bspview
