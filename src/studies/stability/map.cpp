#include "studies/stability/map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "plot/figure/coordinate.hpp"
#include "plot/labels.hpp"
#include "plot/row_choice.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/law.hpp"
#include "sigmasweep/model/relevance.hpp"
#include "solve/fixed_step/stability.hpp"

namespace sigmasweep {
namespace {

constexpr double good = 0.01, fair = 0.1;
constexpr int between = 4;  ///< number of limits from one y to the next, if they are cheap

/// The error of a row; on a plate the imbalance of energy.
Observed observed(const SimulationResult& c) {
  if (c.status == Status::unstable) return Observed::unstable;
  const double error = c.eps_eff == c.eps_eff ? c.eps_eff_error : std::fabs(c.vibration.imbalance);
  if (!(error == error)) return Observed::nothing;
  return error < good ? Observed::good : error < fair ? Observed::fair : Observed::wrong;
}

/// The smallest tc/dt above which the scheme is stable.
double fewest_steps(const Parameters& p) {
  constexpr double most = 1e6, factor = 1.2;
  const ClosedContacts closed = closed_contacts(p);
  const auto stable = [&](double steps) { return is_stable(closed, p.integrator, 1.0 / steps); };
  double high = most;
  while (high > 1.0 && stable(high / factor)) high /= factor;
  double low = high / factor;
  while (high > 1.001 * low) {
    const double middle = std::sqrt(low * high);
    (stable(middle) ? high : low) = middle;
  }
  return high;
}

/// The limits of one map, whose tuples are `by_y`.
std::vector<StabilityLimit> limits_of(const std::map<double, Parameters>& by_y, const Field& y) {
  std::vector<StabilityLimit> limits;
  const StabilityLimit* before = nullptr;
  for (const auto& [value, tuple] : by_y) {
    const bool is_smooth = y.name == "epsilon" && exponents(tuple).linear();
    const double from = before ? before->y : value;
    std::vector<StabilityLimit> added;
    for (int i = 1; before && is_smooth && i < between; ++i) {
      Parameters p = tuple;
      p.epsilon = from + (value - from) * i / between;
      added.push_back({p.epsilon, fewest_steps(p)});
    }
    added.push_back({value, fewest_steps(tuple)});
    limits.insert(limits.end(), added.begin(), added.end());
    before = &limits.back();
  }
  return limits;
}

}  // namespace

PlotSpec stability_plot(std::span<const PlotSpec> plots) {
  if (const auto map = std::ranges::find(plots, PlotKind::stability, &PlotSpec::kind); map != plots.end()) return *map;
  PlotSpec map;
  map.kind = PlotKind::stability;
  return map;
}

const Field& stability_axis(const PlotSpec& plot) {
  const std::string name = plot.y == PlotSpec{}.y ? "epsilon" : plot.y;
  const auto fields = parameter_fields();
  const auto found = std::ranges::find(fields, name, &Field::name);
  if (found == fields.end() || !enumerators(found->type).empty())
    throw UsageError(
        fmt::format("plot: the y of a stability map must be a parameter that is a number, not '{}'", name));
  return *found;
}

std::vector<StabilityMap> stability_maps(std::span<const Row> rows, const PlotSpec& plot,
                                         std::span<const std::string> axes) {
  const Field& y = stability_axis(plot);
  RowChoice chosen(plot.where);
  std::vector<StabilityMap> maps;
  std::vector<std::map<double, Parameters>> tuples;
  for (const Row& row : rows) {
    if (!has_given_steps(row.parameters) || !chosen(row)) continue;
    std::string label, plain;
    for (const std::string& axis : axes) {
      if (axis == y.name || axis == "steps_per_tc") continue;
      const Field& field = plot::field_named(axis);
      label += (label.empty() ? "" : ", ") + plot::value_label(field, row);
      plain += fmt::format("{}{} = {}", plain.empty() ? "" : ", ", axis, text(field, row));
    }
    auto found = std::ranges::find(maps, plain, &StabilityMap::plain_label);
    if (found == maps.end()) {
      maps.push_back({label, plain, {}, {}});
      tuples.emplace_back();
      found = maps.end() - 1;
    }
    const double value = number(y, row), growth = row.result.predicted_growth;
    found->cells.push_back({value, row.parameters.steps_per_tc, observed(row.result),
                            growth == growth ? growth <= max_stable_growth : is_stable(row.parameters)});
    tuples[std::size_t(found - maps.begin())].try_emplace(value, row.parameters);
  }
  if (maps.empty()) throw UsageError("stability: no row has an integrator of fixed step and steps_per_tc");
  for (std::size_t i = 0; i < maps.size(); ++i) maps[i].limits = limits_of(tuples[i], y);
  return maps;
}

}  // namespace sigmasweep
