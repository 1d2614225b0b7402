#include "sigmasweep/assembly/validity.hpp"

#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "sigmasweep/model/geometry.hpp"

namespace sigmasweep {
namespace {

constexpr std::int64_t max_beads = 1'000'000, max_periods = 10'000'000;
constexpr double max_alpha = 1e6, max_flight = 1e9;

std::string refuse(std::string_view name, double value, std::string_view allowed) {
  return fmt::format("{} = {} is not allowed: it must be {}.", name, value, allowed);
}

bool positive(double value) { return std::isfinite(value) && value > 0.0; }
bool not_negative(double value) { return std::isfinite(value) && value >= 0.0; }
bool within(double value, double low, double high) { return value >= low && value <= high; }  // false for NaN

std::string why_plate_invalid(const Parameters& p) {
  if (!positive(p.gravity)) return refuse("gravity", p.gravity, "a finite acceleration > 0 m/s^2");
  if (!positive(p.frequency)) return refuse("frequency", p.frequency, "finite and > 0 Hz");
  if (!positive(p.alpha) || p.alpha > max_alpha)
    return refuse("alpha", p.alpha, fmt::format("> 0 and <= {} (alpha = A0 (2 pi frequency)^2/gravity)", max_alpha));
  if (!positive(p.A0)) return refuse("A0", p.A0, "a finite length > 0 m");
  if (p.periods < 1 || p.periods > max_periods)
    return fmt::format("periods = {} is not allowed: it must be a whole number from 1 to {}.", p.periods, max_periods);
  if (p.transient < 0 || p.transient >= p.periods)
    return fmt::format("transient = {} is not allowed: it must be a whole number from 0 to periods - 1 = {}.",
                       p.transient, p.periods - 1);
  return {};
}

std::string why_lattice_invalid(const Parameters& p) {
  for (const auto& [name, value] : {std::pair("rows", p.rows), std::pair("columns", p.columns)})
    if (value < 1 || value > max_beads)
      return fmt::format("{} = {} is not allowed: it must be a whole number from 1 to {}.", name, value, max_beads);
  if (p.rows * p.columns > max_beads)
    return fmt::format("rows = {}, columns = {} are not allowed: {} beads are the most.", p.rows, p.columns, max_beads);
  if (p.N != p.rows * p.columns)
    return fmt::format("N = {} is not allowed: a lattice has rows times columns = {}.", p.N, p.rows * p.columns);
  if (p.method == Method::ed) return "method = 'ed' is not allowed for a lattice: hard spheres are for columns.";
  if (!is_vibrated(p) && p.sigma * static_cast<double>(p.rows) > max_flight)
    return fmt::format(
        "sigma = {} is not allowed with rows = {}: positions would lose their digits where sigma rows is "
        "above {}.",
        p.sigma, p.rows, max_flight);
  if (!not_negative(p.D_t)) return refuse("D_t", p.D_t, "finite and >= 0 1/s");
  return {};
}

}  // namespace

std::string why_invalid(const Parameters& p) {
  if (!not_negative(p.K_over_m)) return refuse("K_over_m", p.K_over_m, "finite and >= 0");
  if (!not_negative(p.D_n)) return refuse("D_n", p.D_n, "finite and >= 0");
  if (!within(p.beta, 0.0, 4.0)) return refuse("beta", p.beta, "from 0 to 4");
  if (!within(p.gamma, 0.0, 4.0)) return refuse("gamma", p.gamma, "from 0 to 4");
  const bool sticks = p.K_over_m > 0.0 && p.epsilon == 0.0;
  if (sticks && p.method == Method::ed)
    return fmt::format(
        "K_over_m = {}, D_n = {} are not allowed with method = 'ed': at {} m/s a pair is too damped to "
        "come apart again, and hard spheres need epsilon > 0.",
        p.K_over_m, p.D_n, p.v0);
  if (!positive(p.v0)) return refuse("v0", p.v0, "a finite speed > 0 m/s");
  if (!positive(p.tc)) return refuse("tc", p.tc, "a finite time > 0 s");
  if (!not_negative(p.s0)) return refuse("s0", p.s0, "a finite length >= 0 m");
  if (!not_negative(p.sigma)) return refuse("sigma", p.sigma, "finite and >= 0 (sigma = s0/(v0 tc))");
  if (!sticks && (!positive(p.epsilon) || p.epsilon > 1.0)) return refuse("epsilon", p.epsilon, "> 0 and <= 1");
  if (!positive(p.d)) return refuse("d", p.d, "a finite length > 0 m");
  if (!within(p.width, 0.0, 1.99 * p.d)) return refuse("width", p.width, "from 0 to 1.99 d");
  if (p.seed < 0) return fmt::format("seed = {} is not allowed: it must be >= 0.", p.seed);
  if (is_lattice(p))
    if (const std::string why = why_lattice_invalid(p); !why.empty()) return why;
  if (p.N < 1 || p.N > max_beads)
    return fmt::format("N = {} is not allowed: it must be a whole number from 1 to {}.", p.N, max_beads);
  if (is_vibrated(p) && p.method == Method::md && p.integrator != Integrator::exact && !(p.steps_per_tc > 0.0))
    return refuse("steps_per_tc", p.steps_per_tc, "given, > 0, for what vibrates");
  if (p.steps_per_tc != 0.0 && !within(p.steps_per_tc, 2.0, 1e6))
    return refuse("steps_per_tc", p.steps_per_tc, "from 2 to 1e6");
  if (!within(p.tolerance, 1e-15, 0.1)) return refuse("tolerance", p.tolerance, "from 1e-15 to 0.1");
  if (is_vibrated(p)) return why_plate_invalid(p);
  return {};
}

}  // namespace sigmasweep
