#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace sigmasweep {

/// A straight line fitted to each series by least squares, all points alike.
struct FitSpec {
  enum class Form { power, line };  ///< y = A x^b, fitted in the logarithms; y = a + b x
  Form form = Form::power;
  double from = -std::numeric_limits<double>::infinity();  ///< the points with from <= x <= to
  double to = std::numeric_limits<double>::infinity();
};

/// A dashed line to compare with: horizontal at y; a curve, y an expression of x; or with a slope (that of log y
/// against log x where both axes are logarithmic) through a point.
struct GuideSpec {
  std::string label;
  std::optional<double> y{};  ///< horizontal; else:
  std::string curve{};        ///< y as an expression of x (see FunctionOfX); empty:
  double slope = 0.0;
  std::optional<std::array<double, 2>> through{};          ///< the point; else the last one (largest x) of
  std::string where{};                                     ///< the rows drawn for which this holds; empty: of all
  double from = -std::numeric_limits<double>::infinity();  ///< drawn over this range of x only
  double to = std::numeric_limits<double>::infinity();
};

/// What a plot shows: rows as points; the trajectories of rows, a panel each (such a plot has nothing else but name,
/// title, where, and of vibrated columns x = "time" or "phase"); or where a fixed time step is stable (name, title,
/// where, y and y_scale).
enum class PlotKind { points, trajectories, stability };

/// [plot] of a spec, or one of several [[plot]]. Where all columns of a sweep are vibrated it is h_cm_excess against
/// alpha on a linear axis unless the spec says something else.
struct PlotSpec {
  std::string name;  ///< letters, digits, '-', '_'; empty: none
  PlotKind kind = PlotKind::points;
  std::string x = "sigma", y = "eps_eff";  ///< fields, or expressions over them (see Formula)
  std::string y_error;           ///< the same, for error bars; empty: h_cm_error of h_cm and h_cm_excess, else none
  std::string x_label, y_label;  ///< empty: made from x and y
  bool x_log = true, y_log = false;
  std::vector<std::string> series;     ///< names of fields: one curve per distinct combination
  std::string title;                   ///< empty: the sweep's title
  std::string where;                   ///< a condition on the rows drawn (see Where); empty: all
  std::vector<std::string> mean_over;  ///< fields: rows of a series that agree in x but for these are averaged
  bool lines = false;                  ///< the points of a series joined
  std::optional<FitSpec> fit;
  std::vector<GuideSpec> guides;
  bool by_phase = false;  ///< trajectories against the phase of the plate, not time
};

}  // namespace sigmasweep
