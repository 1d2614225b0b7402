#include "plot/figure/curves.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>
#include <ranges>

#include "plot/labels.hpp"

namespace sigmasweep::plot {
namespace {

/// Whether dimensionless results of hard spheres do not depend on the field.
bool same_for_hard_spheres(const Field& field) {
  static constexpr auto names = std::to_array<std::string_view>(
      {"method", "v0", "tc", "s0", "sigma", "d", "integrator", "steps_per_tc", "tolerance"});
  return std::find(names.begin(), names.end(), field.name) != names.end();
}

/// x rounded to 12 digits, so that rounding errors do not tell rows apart.
double rounded(double x) {
  if (x == 0.0) return 0.0;
  const double scale = std::pow(10.0, 11.0 - std::floor(std::log10(std::abs(x))));
  return std::isfinite(scale) ? std::round(x * scale) / scale : x;
}

void append(std::string& text, const std::string& part) { text += (text.empty() ? "" : ", ") + part; }

std::string plain(const Field& field, const Row& row) { return fmt::format("{} = {}", field.name, text(field, row)); }

}  // namespace

Curves::Curves(const PlotSpec& spec, const Coordinate& x, const Coordinate& y, bool with_hard_line)
    : universal_(!y.has_unit()), with_hard_line_(with_hard_line), joined_(spec.lines) {
  for (const auto& name : spec.series) series_.push_back(&field_named(name));
  for (const auto& name : spec.mean_over) mean_over_.push_back(&field_named(name));
  for (const char* name : {"N", "epsilon", "wall"})  // a line has one value of each, even if the key names none
    if (!x.uses(name) && std::ranges::find(spec.mean_over, name) == spec.mean_over.end())
      line_keys_.push_back(&field_named(name));
}

std::size_t Curves::curve_of(const Row& row) {
  const bool hard = row.parameters.method == Method::ed, line = hard && with_hard_line_;
  const bool lrv = row.parameters.ed_rule == EdRule::lrv;
  const bool merged = line && universal_ && lrv;
  std::vector<double> key{hard ? (lrv ? 1.0 : 2.0) : 0.0};
  std::string label, name;
  for (const Field* field : series_) {
    if (!merged || !same_for_hard_spheres(*field)) key.push_back(number(*field, row));
    if (field->name == "ed_rule" && (line || !hard)) continue;  // the line's label has it; soft spheres have none
    if (line && (field->name == "method" || (lrv && same_for_hard_spheres(*field)))) continue;
    append(label, value_label(*field, row));
    append(name, plain(*field, row));
  }
  const std::string rule = lrv ? "ED (LRV)" : "ED (TC)";
  if (line) {
    for (const Field* field : line_keys_) key.push_back(number(*field, row));
    label = label.empty() ? rule : rule + ", " + label;
    name = name.empty() ? rule : rule + ", " + name;
  }
  if (label.empty()) label = name = hard ? rule : "MD";
  const auto [place, fresh] = places_.try_emplace(std::move(key), curves_.size());
  if (fresh) {
    if (!labels_.insert(label).second) label.clear();
    curves_.push_back({.label = std::move(label), .name = std::move(name), .line = line});
  }
  return place->second;
}

std::size_t Curves::add(const Row& row, const Point& point) {
  const std::size_t curve = curve_of(row);
  if (mean_over_.empty())
    curves_[curve].points.push_back(point);
  else
    add_to_mean(curve, row, point);
  return curve;
}

/// Rows that agree in x and in mean_over differ in another parameter and are not averaged with each other: the n-th of
/// them belongs to the n-th mean.
void Curves::add_to_mean(std::size_t curve, const Row& row, const Point& point) {
  std::vector<double> over;
  for (const Field* field : mean_over_) over.push_back(number(*field, row));
  const Place place{curve, rounded(point.x)};
  const std::uint64_t which = seen_[{place, std::move(over)}]++;
  const auto [group, fresh] = groups_.try_emplace({place, which}, means_.size());
  if (fresh) means_.push_back({.curve = curve, .x = point.x, .row = point.row});
  means_[group->second].values.push_back(point.y);
}

void Curves::take_means() {
  if (means_.empty()) return;
  for (const Mean& m : means_) {
    if (m.values.size() == 1) {
      curves_[m.curve].points.push_back({.x = m.x, .y = m.values.front(), .row = m.row});
      continue;
    }
    const auto [mean, variance] = boost::math::statistics::mean_and_sample_variance(m.values);
    curves_[m.curve].points.push_back({m.x, mean, std::sqrt(variance)});
  }
  std::string over;
  for (const Field* field : mean_over_) append(over, symbol_of(*field));
  const auto [min, max] =
      std::ranges::minmax(means_ | std::views::transform([](const Mean& m) { return m.values.size(); }));
  note_ = fmt::format("Means over {}, n = {}, bars: standard deviation", over,
                      min == max ? fmt::format("{}", max) : fmt::format("{} to {}", min, max));
}

std::vector<Curve> Curves::take() {
  take_means();
  for (auto& curve : curves_) {
    if (!curve.line && !joined_) continue;
    curve.path = curve.points;
    std::ranges::stable_sort(curve.path, {}, &Point::x);
    if (curve.line) curve.points.clear();
  }
  return std::move(curves_);
}

}  // namespace sigmasweep::plot
