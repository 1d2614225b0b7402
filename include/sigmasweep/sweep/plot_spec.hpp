#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace sigmasweep {

/// A line fitted to each series by least squares, with equal weights.
struct FitSpec {
  enum class Form { power, line };  ///< y = A x^b, fitted in the logarithms; y = a + b x
  Form form = Form::power;
  double from = -std::numeric_limits<double>::infinity();  ///< points with from <= x <= to are fitted
  double to = std::numeric_limits<double>::infinity();
};

/// A dashed line to compare data with: horizontal at y; a curve; or a straight line with a slope through a point. On
/// two logarithmic axes the slope is that of log y against log x.
struct GuideSpec {
  std::string label;
  std::optional<double> y{};  ///< of a horizontal line
  std::string curve{};        ///< y as an expression of x (see FunctionOfX); empty: none
  double slope = 0.0;
  std::optional<std::array<double, 2>> through{};          ///< the point; none: the last one (see `where`)
  std::string where{};                                     ///< the last one, of largest x, of rows that satisfy it
  double from = -std::numeric_limits<double>::infinity();  ///< the line is drawn for from <= x <= to
  double to = std::numeric_limits<double>::infinity();
};

/// The kind of a plot: rows as points; trajectories of rows, a panel for each (keys: name, title, where, and for a
/// plate x = "time" or "phase"); or the stability of fixed time steps (keys: name, title, where, y and y_scale).
enum class PlotKind { points, trajectories, stability };

/// The table [plot] of a spec, or one of several [[plot]]. If all tuples of the sweep are vibrated, the default is
/// h_cm_excess against alpha on a linear axis.
struct PlotSpec {
  std::string name;  ///< letters, digits, '-', '_'; may be empty
  PlotKind kind = PlotKind::points;
  std::string x = "sigma", y = "eps_eff";  ///< fields, or expressions over them (see Formula)
  std::string y_error;           ///< field or expression for error bars; empty: h_cm_error of h_cm and h_cm_excess
  std::string x_label, y_label;  ///< empty: made from x and y
  bool x_log = true, y_log = false;
  std::vector<std::string> series;     ///< names of fields: a curve for each combination of their values
  std::string title;                   ///< empty: the sweep's title
  std::string where;                   ///< condition on the rows that are drawn (see Where); empty: all rows
  std::vector<std::string> mean_over;  ///< names of fields: rows that differ in these only are averaged
  bool lines = false;                  ///< the points of a series are joined
  std::optional<FitSpec> fit;
  std::vector<GuideSpec> guides;
  bool by_phase = false;  ///< trajectories against the phase of the plate instead of time
};

}  // namespace sigmasweep
