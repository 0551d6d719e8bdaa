#pragma once

#include <string>
#include <utility>
#include <vector>

namespace bspview {

/// A mark in a plot, of the class `kind` (see plot_style).
struct PlotPoint {
  double x = 1.0, y = 1.0;  ///< > 0
  double x_spread = 0.0;    ///< half of the length of the bar through it
  std::string label;        ///< empty: none
  std::string tip;          ///< shown by the pointer
  std::string kind;
  bool open = false;    ///< nothing was found: y is an upper bound
  bool ringed = false;  ///< the default
  bool strong = false;  ///< its label comes first, and in full strength
};

struct PlotLine {
  std::vector<std::pair<double, double>> points;
  std::string kind;
};

/// Both axes in logarithms.
struct Plot {
  std::string title, x_title, y_title;
  /// A few points farther to the right than so many times the median are named below the plot
  /// instead of pressing the others together.
  double farthest = 1.6;
  bool whole_decades = true;  ///< of the y axis
  std::vector<PlotPoint> points;
  std::vector<PlotLine> lines;
};

/// The plot as an SVG element. Labels are left out where they would lie on one another.
std::string draw_plot(const Plot& plot);

/// Rules of style for every class that plots use: for light and dark pages.
std::string plot_style();

/// `text` where markup is read.
std::string escape_markup(const std::string& text);

}  // namespace bspview
