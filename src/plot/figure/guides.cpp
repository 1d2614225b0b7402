#include "plot/figure/guides.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "plot/figure/coordinate.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep::plot {
namespace {

/// The point of the curve that is nearest to x, which may be a mean.
Point point_at(const Curve& curve, double x) {
  const auto& points = curve.line ? curve.path : curve.points;
  return *std::ranges::min_element(points, {}, [x](const Point& p) { return std::abs(p.x - x); });
}

/// Points of the smooth curve y(x), without the points that cannot be drawn.
std::vector<Point> curve(const std::string& expression, double from, double to, const Figure& figure) {
  constexpr int pieces = 200;
  FunctionOfX y(expression);
  std::vector<Point> points;
  for (int k = 0; k <= pieces; ++k) {
    const double place = std::lerp(fraction(figure.x, from), fraction(figure.x, to), static_cast<double>(k) / pieces);
    const Point point{value_at(figure.x, place), y(value_at(figure.x, place))};
    if (std::isfinite(point.y) && !(figure.y.log && point.y <= 0.0)) points.push_back(point);
  }
  return points;
}

}  // namespace

Guides::Guides(const PlotSpec& spec) {
  for (const GuideSpec& guide : spec.guides) {
    guides_.push_back({guide, std::nullopt, std::nullopt});
    if (!guide.where.empty()) guides_.back().where.emplace(guide.where, all_fields());
    if (!guide.y && guide.curve.empty() && spec.x_log != spec.y_log)
      throw UsageError("plot: a guide with a slope needs two logarithmic axes, or two linear ones");
  }
}

void Guides::add(const Row& row, std::size_t curve, double x) {
  for (Anchored& guide : guides_) {
    const bool needs_anchor = !guide.spec.y && guide.spec.curve.empty() && !guide.spec.through;
    if (!needs_anchor || (guide.last && guide.last->second >= x)) continue;
    if (!guide.where || (*guide.where)(row)) guide.last = {curve, x};
  }
}

std::vector<Guide> Guides::lines(const Figure& figure) const {
  std::vector<Guide> lines;
  for (const Anchored& guide : guides_) {
    const GuideSpec& spec = guide.spec;
    const double from = std::max(spec.from, figure.x.from), to = std::min(spec.to, figure.x.to);
    if (!(from < to)) continue;
    if (!spec.curve.empty()) {
      lines.push_back({spec.label, curve(spec.curve, from, to, figure)});
      continue;
    }
    Point anchor{from, spec.y.value_or(0.0)};
    if (spec.through)
      anchor = {(*spec.through)[0], (*spec.through)[1]};
    else if (guide.last)
      anchor = point_at(figure.curves[guide.last->first], guide.last->second);
    else if (!spec.y)
      continue;
    const auto y = [&](double x) {
      if (spec.y) return *spec.y;
      return figure.x.log ? anchor.y * std::pow(x / anchor.x, spec.slope) : anchor.y + spec.slope * (x - anchor.x);
    };
    lines.push_back({spec.label, {{from, y(from)}, {to, y(to)}}});
  }
  return lines;
}

}  // namespace sigmasweep::plot
