#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sigmasweep/sweep/sweep.hpp"

namespace sigmasweep::plot {

struct Point;

/// A fitted line: y = A x^b (power) or y = A + b x (line).
struct Fit {
  FitSpec::Form form = FitSpec::Form::power;
  double slope = 0.0;        ///< b
  double slope_error = 0.0;  ///< standard error of b, from the scatter of the points; NaN for two points
  double prefactor = 0.0;    ///< A
  std::uint64_t points = 0;
  double from = 0.0, to = 0.0;  ///< smallest and largest x fitted

  double operator()(double x) const;
};

/// Fits by ordinary least squares, for a power in the logarithms. Returns nothing for fewer than two different x.
std::optional<Fit> fit(const std::vector<Point>& points, const FitSpec& spec);

/// A value with its error, rounded to the digits that the error allows: "−0.431 ± 0.002".
std::string with_error(double value, double error);

}  // namespace sigmasweep::plot
