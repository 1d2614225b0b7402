#pragma once

#include <span>
#include <string>
#include <vector>

#include "sigmasweep/sweep/row.hpp"
#include "sigmasweep/sweep/sweep.hpp"

/// What a plot shows, before anybody asks how it is drawn.
namespace sigmasweep::plot {

struct Point {
  double x, y;
};

struct Curve {
  std::string label;  ///< for the key, in gnuplot's enhanced text; empty: none
  bool line = false;  ///< hard spheres: a dashed line; soft ones: symbols
  std::vector<Point> points;
};

struct Axis {
  std::string label;  ///< enhanced text
  bool log = false;
  double from = 0.0, to = 1.0;  ///< a little more than the data
};

struct Figure {
  std::string title;  ///< as the user wrote it
  std::string note;   ///< what is not drawn; enhanced text
  Axis x, y;
  std::vector<Curve> curves;
};

/// Where on the axis `value` is: 0 at its beginning, 1 at its end.
double fraction(const Axis& axis, double value);

/// The rows that can be drawn, sorted into curves in the order in which they first appear.
/// Throws UsageError for a field that is not there or is not a number.
Figure figure_of(std::span<const Row> rows, const PlotSpec& spec, const std::string& title);

}  // namespace sigmasweep::plot
