#include "plot/figure/figure.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "plot/figure/coordinate.hpp"
#include "plot/figure/curves.hpp"
#include "plot/figure/guides.hpp"
#include "plot/labels.hpp"
#include "plot/range.hpp"
#include "plot/row_choice.hpp"

namespace sigmasweep::plot {
namespace {

/// Numbers of rows that are not drawn, by reason.
struct Dropped {
  std::uint64_t failed = 0, not_positive_x = 0, not_positive_y = 0, not_finite = 0;
};

void append(std::string& note, const std::string& part) {
  if (!part.empty()) note += (note.empty() ? "" : "; ") + part;
}

std::string note_of(const Dropped& dropped, const Coordinate& x, const Coordinate& y) {
  std::string note;
  const auto add = [&note](std::uint64_t count, const std::string& why) {
    if (count == 0) return;
    note += fmt::format("{}{} {} {}", note.empty() ? "Not drawn: " : "; ", count, count == 1 ? "row" : "rows", why);
  };
  add(dropped.failed, "that failed");
  add(dropped.not_positive_x, fmt::format("with {} ≤ 0 (logarithmic axis)", x.symbol()));
  add(dropped.not_positive_y, fmt::format("with {} ≤ 0 (logarithmic axis)", y.symbol()));
  add(dropped.not_finite, "without a finite value");
  return note;
}

/// The rows that satisfy the plot's condition.
std::vector<const Row*> chosen(std::span<const Row> rows, const std::string& where) {
  std::vector<const Row*> kept;
  RowChoice is_chosen(where);
  for (const Row& row : rows)
    if (is_chosen(row)) kept.push_back(&row);
  return kept;
}

bool occurs(const std::vector<const Row*>& rows, Method method) {
  return std::ranges::any_of(
      rows, [&](const Row* row) { return row->parameters.method == method && is_success(row->result.status); });
}

/// Fits a line to each series of symbols and adds its slope to the key. Returns a note of the series without a fit.
std::string fit_all(std::vector<Curve>& curves, const FitSpec& spec) {
  std::string note;
  for (Curve& curve : curves) {
    if (curve.line) continue;
    curve.fit = fit(curve.points, spec);
    if (!curve.fit)
      append(note, fmt::format("no fit for {}: fewer than two points in the range", escape_markup(curve.name)));
    else if (!curve.label.empty())
      curve.label += ": slope " + with_error(curve.fit->slope, curve.fit->slope_error);
  }
  return note;
}

double to_scale(const PlotAxis& axis, double value) { return axis.log ? std::log10(value) : value; }
double from_scale(const PlotAxis& axis, double value) { return axis.log ? std::pow(10.0, value) : value; }

/// The range of the data along an axis, as logarithms on a logarithmic axis.
class AxisRange {
 public:
  explicit AxisRange(PlotAxis& axis) : axis_(axis) {}
  void include(double value) {
    if (!axis_.log || value > 0.0) range_.include(to_scale(axis_, value));
  }
  /// Sets the ends of the axis: the range with a margin on both sides. Values that differ by rounding only count as one
  /// value: between them there is no room for the labels of the axis.
  void set_axis() {
    constexpr double rounding = 1e-12;
    const auto [low, high] = range_.is_empty() ? Range{0.0, 0.0} : range_;
    const double size = std::max(std::abs(low), std::abs(high)),
                 one_value = axis_.log ? 0.5 : std::max(0.5 * size, 1e-3);
    const double margin =
        high - low > rounding * (axis_.log ? std::max(size, 1.0) : size) ? 0.04 * (high - low) : one_value;
    axis_.from = from_scale(axis_, low - margin);
    axis_.to = from_scale(axis_, high + margin);
  }

 private:
  PlotAxis& axis_;
  Range range_;
};

void set_ranges(Figure& figure, const PlotSpec& spec) {
  AxisRange x(figure.x), y(figure.y);
  for (const auto& curve : figure.curves)
    for (const auto* points : {&curve.points, &curve.path})
      for (const auto& point : *points) {
        x.include(point.x);
        y.include(point.y - point.deviation);
        y.include(point.y + point.deviation);
      }
  for (const GuideSpec& guide : spec.guides)
    if (guide.y) y.include(*guide.y);
  x.set_axis();
  y.set_axis();
}

/// Symbols of each curve, one for a cell of about a symbol's size. The curve with the fewest symbols so far gets the
/// cell, so that curves on one line all stay visible. `shared`: only cells that several curves share.
std::vector<std::vector<Point>> one_a_cell(const Figure& figure, bool shared) {
  constexpr double columns = 110.0, lines = 75.0;
  std::map<std::pair<long, long>, std::map<std::size_t, Point>> cells;
  for (std::size_t i = 0; i < figure.curves.size(); ++i)
    for (const Point& p : figure.curves[i].points)
      cells[{std::lround(columns * fraction(figure.x, p.x)), std::lround(lines * fraction(figure.y, p.y))}].try_emplace(
          i, p);
  std::vector<std::vector<Point>> chosen(figure.curves.size());
  for (const auto& [place, candidates] : cells) {
    if (shared && candidates.size() < 2) continue;
    const auto so_far = [&](const auto& candidate) { return chosen[candidate.first].size(); };
    const auto& [curve, point] = *std::ranges::min_element(candidates, {}, so_far);
    chosen[curve].push_back(point);
  }
  return chosen;
}

std::size_t size_of(const std::vector<std::vector<Point>>& curves) {
  return std::accumulate(curves.begin(), curves.end(), std::size_t{0},
                         [](std::size_t sum, const auto& points) { return sum + points.size(); });
}

/// Chooses the symbols that are drawn in front of others. Of a huge sweep, whose picture would be huge, it leaves the
/// others out and returns a note that says so.
std::string arrange_symbols(Figure& figure) {
  constexpr std::size_t few = 5000;
  std::size_t all = 0;
  for (const Curve& curve : figure.curves) all += curve.points.size();
  std::vector<std::vector<Point>> chosen = one_a_cell(figure, all <= few);
  const std::size_t drawn = size_of(chosen);
  for (std::size_t i = 0; i < chosen.size(); ++i)
    (all <= few ? figure.curves[i].front : figure.curves[i].points) = std::move(chosen[i]);
  return all <= few ? "" : fmt::format("{} of {} symbols are drawn, the others are at the same places", drawn, all);
}

/// The field or expression for error bars; empty if there are none.
std::string error_of(const PlotSpec& spec) {
  if (!spec.y_error.empty() || !spec.mean_over.empty()) return spec.y_error;
  return spec.y == "h_cm" || spec.y == "h_cm_excess" ? "h_cm_error" : "";
}

}  // namespace

double fraction(const PlotAxis& axis, double value) {
  const double from = to_scale(axis, axis.from), to = to_scale(axis, axis.to);
  return (to_scale(axis, value) - from) / (to - from);
}

double value_at(const PlotAxis& axis, double fraction) {
  const double from = to_scale(axis, axis.from), to = to_scale(axis, axis.to);
  return from_scale(axis, from + fraction * (to - from));
}

std::vector<Point> fitted_line(const Figure& figure, const Fit& fit) {
  constexpr int pieces = 100;
  const double from = fraction(figure.x, fit.from), to = fraction(figure.x, fit.to);
  std::vector<Point> points;
  for (int k = 0; k <= pieces; ++k) {
    const double x = value_at(figure.x, from + (to - from) * k / pieces);
    points.push_back({x, fit(x)});
  }
  return points;
}

Figure figure_of(std::span<const Row> rows, const PlotSpec& spec, const std::string& title) {
  Coordinate x(spec.x), y(spec.y);
  std::optional<Coordinate> error;
  if (const std::string field = error_of(spec); !field.empty()) error.emplace(field);
  Figure figure;
  figure.title = spec.title.empty() ? title : spec.title;
  figure.x = {.label = spec.x_label.empty() ? x.axis_label() : spec.x_label, .log = spec.x_log};
  figure.y = {.label = spec.y_label.empty() ? y.axis_label() : spec.y_label, .log = spec.y_log};

  const auto drawable = chosen(rows, spec.where);
  Dropped dropped;
  // Hard spheres beside soft ones are drawn as a line, which cannot have error bars.
  Curves curves(spec, x, y, !error && occurs(drawable, Method::md) && occurs(drawable, Method::ed));
  Guides guides(spec);
  for (const Row* row : drawable) {
    const double deviation = error ? (*error)(*row) : 0.0;
    const Point point{x(*row), y(*row), std::isfinite(deviation) ? deviation : 0.0,
                      static_cast<std::size_t>(row - rows.data())};
    if (!is_success(row->result.status))
      ++dropped.failed;
    else if (!std::isfinite(point.x) || !std::isfinite(point.y))
      ++dropped.not_finite;
    else if (spec.x_log && point.x <= 0.0)
      ++dropped.not_positive_x;
    else if (spec.y_log && point.y <= 0.0)
      ++dropped.not_positive_y;
    else
      guides.add(*row, curves.add(*row, point), point.x);
  }
  figure.curves = curves.take();
  figure.note = note_of(dropped, x, y);
  append(figure.note, curves.note());
  if (spec.fit) append(figure.note, fit_all(figure.curves, *spec.fit));
  set_ranges(figure, spec);
  figure.guides = guides.lines(figure);
  if (spec.mean_over.empty() && !error)
    append(figure.note, arrange_symbols(figure));  // points with error bars are all kept
  return figure;
}

}  // namespace sigmasweep::plot
