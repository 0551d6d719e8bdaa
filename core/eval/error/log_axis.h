#pragma once

#include <string>
#include <vector>

namespace bspview {

/// A place on an axis and what stands there; minor ones have no text.
struct Tick {
  double value = 0.0;
  std::string text;  ///< may hold markup: powers of ten
};

/// A logarithmic axis from `lo` to `hi` over pixels `from` to `to`.
struct LogAxis {
  double lo = 1.0, hi = 10.0;
  double from = 0.0, to = 1.0;

  double place(double value) const;
  /// Between two and ten, at round numbers: powers of ten on a long axis, with their doubles and
  /// fivefolds on one of up to three, even steps on one of less than one.
  std::vector<Tick> ticks() const;
};

/// The axis, widened to powers of ten.
LogAxis whole_decades(LogAxis axis);

/// The axis around all values (> 0), with a little room at both ends.
LogAxis fit_axis(const std::vector<double>& values, double from, double to);

}  // namespace bspview
