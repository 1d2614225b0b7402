#include "sigmasweep/assembly/validity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/geometry.hpp"

namespace sigmasweep {
namespace {

constexpr std::int64_t max_beads = 1'000'000;
constexpr double max_flight = 1e9;

/// All parameters; before tc and epsilon those that they may follow from, so that a message names the cause.
const std::vector<ParameterField>& causes_first() {
  static const std::vector<ParameterField> fields = [] {
    constexpr std::array<std::string_view, 4> causes{"K_over_m", "D_n", "beta", "gamma"};
    const auto all = fields_of_parameters();
    std::vector<ParameterField> ordered(all.begin(), all.end());
    std::ranges::stable_partition(
        ordered, [&](const ParameterField& field) { return std::ranges::find(causes, field.name) != causes.end(); });
    return ordered;
  }();
  return fields;
}

/// The first parameter whose value is not allowed, whatever the others are.
std::string why_value_refused(const Parameters& p) {
  for (const ParameterField& field : causes_first()) {
    if (field.allowed.checked && !field.allowed.checked(p)) continue;
    const double value = number(field, p);
    if (!field.allowed.contain || field.allowed.contain(value)) continue;
    return why_refused(field, value, text(field, p));
  }
  return {};
}

/// Each of rows and columns is allowed, but not both together.
bool has_too_many_beads(const Parameters& p) {
  return is_lattice(p) && p.rows >= 1 && p.rows <= max_beads && p.columns > max_beads / p.rows &&
         p.columns <= max_beads;
}

std::string why_lattice_refused(const Parameters& p) {
  if (p.N != p.rows * p.columns)
    return fmt::format("N = {} is not allowed: a lattice has rows times columns = {}.", p.N, p.rows * p.columns);
  if (p.method == Method::ed) return "method = 'ed' is not allowed for a lattice: hard spheres are for columns.";
  if (!is_vibrated(p) && p.sigma * static_cast<double>(p.rows) > max_flight)
    return fmt::format(
        "sigma = {} is not allowed with rows = {}: positions would lose their digits where sigma rows is "
        "above {}.",
        p.sigma, p.rows, max_flight);
  return {};
}

/// What parameters that are allowed one by one must be together.
std::string why_not_together(const Parameters& p) {
  if (p.K_over_m > 0.0 && p.epsilon == 0.0 && p.method == Method::ed)
    return fmt::format(
        "K_over_m = {}, D_n = {} are not allowed with method = 'ed': at {} m/s a pair is too damped to "
        "come apart again, and hard spheres need epsilon > 0.",
        p.K_over_m, p.D_n, p.v0);
  if (!(p.width <= 1.99 * p.d)) return fmt::format("width = {} is not allowed: it must be from 0 to 1.99 d.", p.width);
  if (is_lattice(p))
    if (std::string why = why_lattice_refused(p); !why.empty()) return why;
  if (!is_vibrated(p)) return {};
  if (p.method == Method::md && p.integrator != Integrator::exact && !(p.steps_per_tc > 0.0))
    return fmt::format("steps_per_tc = {} is not allowed: it must be given, > 0, for what vibrates.", p.steps_per_tc);
  if (p.transient >= p.periods)
    return fmt::format("transient = {} is not allowed: it must be a whole number from 0 to periods - 1 = {}.",
                       p.transient, p.periods - 1);
  return {};
}

}  // namespace

std::string why_invalid(const Parameters& p) {
  if (has_too_many_beads(p))
    return fmt::format("rows = {}, columns = {} are not allowed: {} beads are the most.", p.rows, p.columns, max_beads);
  std::string why = why_value_refused(p);
  return why.empty() ? why_not_together(p) : why;
}

}  // namespace sigmasweep
