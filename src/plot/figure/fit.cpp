#include "plot/figure/fit.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "plot/figure/figure.hpp"

namespace sigmasweep::plot {
namespace {

/// Whether the fit uses the point at x. Both ends of the range belong to it, with a margin for rounding.
bool is_within(double x, const FitSpec& spec) {
  const double slack = 1e-9 * std::abs(x);
  return x >= spec.from - slack && x <= spec.to + slack;
}

}  // namespace

double Fit::operator()(double x) const {
  return form == FitSpec::Form::power ? prefactor * std::pow(x, slope) : prefactor + slope * x;
}

std::optional<Fit> fit(const std::vector<Point>& points, const FitSpec& spec) {
  const bool power = spec.form == FitSpec::Form::power;
  std::vector<Point> used;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Fit result{.form = spec.form, .from = infinity, .to = -infinity};
  for (const Point& p : points) {
    if (!is_within(p.x, spec) || (power && !(p.x > 0.0 && p.y > 0.0))) continue;
    used.push_back(power ? Point{std::log(p.x), std::log(p.y)} : p);
    result.from = std::min(result.from, p.x);
    result.to = std::max(result.to, p.x);
  }
  if (!(result.from < result.to)) return std::nullopt;

  const double n = static_cast<double>(used.size());
  double x_mean = 0.0, y_mean = 0.0, xx = 0.0, xy = 0.0, residuals = 0.0;
  for (const Point& p : used) x_mean += p.x / n, y_mean += p.y / n;
  for (const Point& p : used) {
    xx += (p.x - x_mean) * (p.x - x_mean);
    xy += (p.x - x_mean) * (p.y - y_mean);
  }
  result.slope = xy / xx;
  for (const Point& p : used) {
    const double residual = p.y - y_mean - result.slope * (p.x - x_mean);
    residuals += residual * residual;
  }
  result.slope_error = used.size() > 2 ? std::sqrt(residuals / ((n - 2.0) * xx)) : std::nan("");
  const double intercept = y_mean - result.slope * x_mean;
  result.prefactor = power ? std::exp(intercept) : intercept;
  result.points = used.size();
  return result;
}

namespace {
constexpr int max_decimals = 4;
}

std::string with_error(double value, double error) {
  std::string text;
  if (!(error > 1e-9 * std::abs(value)) || !std::isfinite(error)) {  // the error is unknown, or rounding only
    text = fmt::format("{:.4g}", value);
  } else {
    double power = std::floor(std::log10(error));
    if (error / std::pow(10.0, power) < 2.0) power -= 1.0;  // two digits of an error that begins with 1
    const int decimals = std::max(static_cast<int>(-power), 0);
    if (decimals > max_decimals)
      text = fmt::format("{:.{}f}", value, max_decimals);
    else
      text = fmt::format("{:.{}f} ± {:.{}f}", value, decimals, error, decimals);
  }
  if (text.starts_with('-')) text.replace(0, 1, "−");
  return text;
}

}  // namespace sigmasweep::plot
