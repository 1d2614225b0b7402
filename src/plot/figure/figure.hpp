#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plot/figure/fit.hpp"
#include "sigmasweep/model/row.hpp"
#include "sigmasweep/sweep/sweep.hpp"

/// A figure as data: curves, guides and axes, independent of the program that draws them.
namespace sigmasweep::plot {

struct Point {
  static constexpr std::size_t no_row = SIZE_MAX;
  double x, y;
  double deviation = 0.0;    ///< length of the error bar: standard deviation or error of y; 0: no bar
  std::size_t row = no_row;  ///< its place among the rows of the figure; none for a mean
};

struct Curve {
  std::string label;  ///< entry of the key, in gnuplot's enhanced text; empty: none
  std::string name;   ///< the values of the series, as plain text
  bool line = false;  ///< drawn as a dashed line (hard spheres beside soft ones) instead of symbols
  std::vector<Point> points{};
  std::vector<Point> front{};  ///< those of the points that are drawn in front of other curves
  std::vector<Point> path{};   ///< the points to be joined, from left to right; may be empty
  std::optional<Fit> fit{};
};

/// A dashed line to compare the data with.
struct Guide {
  std::string label;        ///< enhanced text
  std::vector<Point> path;  ///< from left to right; two points are joined by a straight line on the picture
};

struct PlotAxis {
  std::string label;  ///< enhanced text
  bool log = false;
  double from = 0.0, to = 1.0;  ///< the range of the data with a margin
};

struct Figure {
  std::string title;  ///< as the user wrote it
  std::string note;   ///< numbers of rows that are not drawn, fields that are averaged; enhanced text
  PlotAxis x, y;
  std::vector<Curve> curves;
  std::vector<Guide> guides;
};

/// The position of `value` on the axis: 0 at its beginning, 1 at its end.
double fraction(const PlotAxis& axis, double value);
/// The value at this position.
double value_at(const PlotAxis& axis, double fraction);

/// A fitted line as points, because a power is not straight on linear axes, nor a line on logarithmic ones.
std::vector<Point> fitted_line(const Figure& figure, const Fit& fit);

/// The figure of the rows that can be drawn. Curves are in the order in which they first appear. Throws UsageError for
/// an unknown field, a field that is not a number, and a bad expression.
Figure figure_of(std::span<const Row> rows, const PlotSpec& spec, const std::string& title);

}  // namespace sigmasweep::plot
