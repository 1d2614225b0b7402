#include "plot_figure.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "plot_labels.hpp"
#include "sigmasweep/errors.hpp"
#include "sigmasweep/sweep/spelling.hpp"

namespace sigmasweep::plot {
namespace {

const Field& field_named(const std::string& name) {
  if (const Field* field = find_field(name)) return *field;
  std::vector<std::string_view> known;
  for (const auto part : {parameter_fields(), result_fields(), timing_fields()})
    for (const Field& field : part) known.push_back(field.name);
  throw UsageError(fmt::format("plot: there is no field '{}'{}", name, hint(name, known)));
}

const Field& numeric_field_named(const std::string& name) {
  const Field& field = field_named(name);
  const bool number = field.type == FieldType::real || field.type == FieldType::integer ||
                      field.type == FieldType::unsigned_integer || field.type == FieldType::integer32;
  if (!number) throw UsageError(fmt::format("plot: '{}' is not a number and cannot be an axis", name));
  return field;
}

/// What is left out, for the note.
struct Dropped {
  std::uint64_t failed = 0, not_positive_x = 0, not_positive_y = 0, not_finite = 0;
};

std::string note_of(const Dropped& dropped, const Field& x, const Field& y) {
  std::string note;
  const auto add = [&note](std::uint64_t count, const std::string& what) {
    if (count == 0) return;
    note += fmt::format("{}{} {} {}", note.empty() ? "Not drawn: " : "; ", count, count == 1 ? "row" : "rows", what);
  };
  add(dropped.failed, "that failed");
  add(dropped.not_positive_x, fmt::format("with {} ≤ 0 (logarithmic axis)", symbol_of(x)));
  add(dropped.not_positive_y, fmt::format("with {} ≤ 0 (logarithmic axis)", symbol_of(y)));
  add(dropped.not_finite, "without a finite value");
  return note;
}

/// Hard spheres know neither v0, tc nor the gap: their results without a unit are the same for all.
bool same_for_hard_spheres(const Field& field) {
  static constexpr auto names = std::to_array<std::string_view>(
      {"method", "v0", "tc", "s0", "sigma", "d", "integrator", "steps_per_tc", "tolerance"});
  return std::find(names.begin(), names.end(), field.name) != names.end();
}

/// Sorts rows into curves.
class Curves {
 public:
  Curves(const PlotSpec& spec, const Field& x, const Field& y) {
    for (const auto& name : spec.series) series_.push_back(&field_named(name));
    for (const char* name : {"N", "epsilon", "wall"})  // a line must not jump between these, named in the key or not
      if (name != x.name) line_keys_.push_back(&field_named(name));
    universal_ = y.unit == "1";
  }

  Curve& of(const Row& row) {
    const bool line = row.parameters.method == Method::ed;
    std::vector<double> key{line ? 1.0 : 0.0};
    std::string label;
    for (const Field* field : series_) {
      if (!line || !universal_ || !same_for_hard_spheres(*field)) key.push_back(number(*field, row));
      if (line && same_for_hard_spheres(*field)) continue;
      label += (label.empty() ? "" : ", ") + value_label(*field, row);
    }
    if (line) {
      for (const Field* field : line_keys_) key.push_back(number(*field, row));
      label = label.empty() ? "ED (LRV)" : "ED (LRV), " + label;
    }
    if (label.empty()) label = "MD";
    const auto [place, fresh] = places_.try_emplace(std::move(key), curves_.size());
    if (fresh) {
      if (!labels_.insert(label).second) label.clear();
      curves_.push_back({std::move(label), line, {}});
    }
    return curves_[place->second];
  }

  std::vector<Curve> take() {
    for (auto& curve : curves_)
      if (curve.line) std::ranges::stable_sort(curve.points, {}, &Point::x);
    return std::move(curves_);
  }

 private:
  std::vector<const Field*> series_, line_keys_;
  bool universal_ = true;
  std::map<std::vector<double>, std::size_t> places_;
  std::set<std::string> labels_;
  std::vector<Curve> curves_;
};

double to_scale(const Axis& axis, double value) { return axis.log ? std::log10(value) : value; }
double from_scale(const Axis& axis, double value) { return axis.log ? std::pow(10.0, value) : value; }

/// The range of one coordinate with a margin on both sides.
void set_range(Axis& axis, const std::vector<Curve>& curves, double Point::*coordinate) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto& curve : curves)
    for (const auto& point : curve.points) {
      low = std::min(low, to_scale(axis, point.*coordinate));
      high = std::max(high, to_scale(axis, point.*coordinate));
    }
  if (!(low <= high)) low = high = 0.0;
  const double margin = high > low ? 0.04 * (high - low) : axis.log ? 0.5 : std::max(0.5 * std::abs(low), 1e-3);
  axis.from = from_scale(axis, low - margin);
  axis.to = from_scale(axis, high + margin);
}

/// Of symbols that would cover each other, in a cell of about a symbol's size, one is drawn, and the curves take turns:
/// where they all fall on one line each of them stays visible, and the picture of a huge sweep stays small.
void take_turns(Figure& figure) {
  constexpr double columns = 110.0, lines = 75.0;
  std::map<std::pair<long, long>, std::map<std::size_t, Point>> cells;
  for (std::size_t i = 0; i < figure.curves.size(); ++i) {
    if (figure.curves[i].line) continue;
    for (const Point& p : figure.curves[i].points)
      cells[{std::lround(columns * fraction(figure.x, p.x)), std::lround(lines * fraction(figure.y, p.y))}].try_emplace(
          i, p);
    figure.curves[i].points.clear();
  }
  for (const auto& [place, candidates] : cells) {
    const auto drawn = [&](const auto& candidate) { return figure.curves[candidate.first].points.size(); };
    const auto& [curve, point] = *std::ranges::min_element(candidates, {}, drawn);
    figure.curves[curve].points.push_back(point);
  }
}

}  // namespace

double fraction(const Axis& axis, double value) {
  const double from = to_scale(axis, axis.from), to = to_scale(axis, axis.to);
  return (to_scale(axis, value) - from) / (to - from);
}

Figure figure_of(std::span<const Row> rows, const PlotSpec& spec, const std::string& title) {
  const Field& x = numeric_field_named(spec.x);
  const Field& y = numeric_field_named(spec.y);
  Figure figure;
  figure.title = spec.title.empty() ? title : spec.title;
  figure.x = {.label = axis_label(x), .log = spec.x_log};
  figure.y = {.label = axis_label(y), .log = spec.y_log};

  Dropped dropped;
  Curves curves(spec, x, y);
  for (const Row& row : rows) {
    const Point point{number(x, row), number(y, row)};
    if (!is_success(row.collision.status))
      ++dropped.failed;
    else if (!std::isfinite(point.x) || !std::isfinite(point.y))
      ++dropped.not_finite;
    else if (spec.x_log && point.x <= 0.0)
      ++dropped.not_positive_x;
    else if (spec.y_log && point.y <= 0.0)
      ++dropped.not_positive_y;
    else
      curves.of(row).points.push_back(point);
  }
  figure.note = note_of(dropped, x, y);
  figure.curves = curves.take();
  set_range(figure.x, figure.curves, &Point::x);
  set_range(figure.y, figure.curves, &Point::y);
  take_turns(figure);
  return figure;
}

}  // namespace sigmasweep::plot
