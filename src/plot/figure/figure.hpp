#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plot/figure/fit.hpp"
#include "sigmasweep/model/row.hpp"
#include "sigmasweep/sweep/sweep.hpp"

/// What a plot shows, before anybody asks how it is drawn.
namespace sigmasweep::plot {

struct Point {
  double x, y;
  double deviation = 0.0;  ///< standard deviation or error of y, for a bar; 0: none
};

struct Curve {
  std::string label;  ///< for the key, in gnuplot's enhanced text; empty: none
  std::string name;   ///< what the series is, as plain text
  bool line = false;  ///< hard spheres beside soft ones: a dashed line; else symbols
  std::vector<Point> points{};
  std::vector<Point> path{};  ///< the points to be joined, from left to right; empty: none
  std::optional<Fit> fit{};
};

/// A dashed line to compare with.
struct Guide {
  std::string label;        ///< enhanced text
  std::vector<Point> path;  ///< from left to right; two points: straight on the picture
};

struct PlotAxis {
  std::string label;  ///< enhanced text
  bool log = false;
  double from = 0.0, to = 1.0;  ///< a little more than the data
};

struct Figure {
  std::string title;  ///< as the user wrote it
  std::string note;   ///< what is not drawn, what is averaged; enhanced text
  PlotAxis x, y;
  std::vector<Curve> curves;
  std::vector<Guide> guides;
};

/// Where on the axis `value` is: 0 at its beginning, 1 at its end.
double fraction(const PlotAxis& axis, double value);
/// The value there.
double value_at(const PlotAxis& axis, double fraction);

/// The rows that can be drawn, sorted into curves in the order in which they first appear.
/// Throws UsageError for a field that is not there or is not a number, and for a bad expression.
Figure figure_of(std::span<const Row> rows, const PlotSpec& spec, const std::string& title);

}  // namespace sigmasweep::plot
