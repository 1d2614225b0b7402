#include "sigmasweep/scene/parameters.hpp"

#include <cmath>
#include <string_view>

#include <fmt/format.h>

namespace sigmasweep {
namespace {

constexpr std::int64_t max_beads = 1'000'000;

std::string refuse(std::string_view name, double value, std::string_view allowed) {
  return fmt::format("{} = {} is not allowed: it must be {}.", name, value, allowed);
}

bool positive(double value) { return std::isfinite(value) && value > 0.0; }
bool not_negative(double value) { return std::isfinite(value) && value >= 0.0; }
bool within(double value, double low, double high) { return value >= low && value <= high; }  // false for NaN

}  // namespace

Parameters complete(Parameters parameters, Gap given) {
  // One product for both ways: rows with the same s0, v0, tc get the same sigma to the bit. Nothing to divide when
  // s0 = 0, so that a v0 tc too small for a double does no harm there.
  const double unit_length = parameters.v0 * parameters.tc;
  if (given == Gap::s0)
    parameters.sigma = parameters.s0 == 0.0 ? 0.0 : parameters.s0 / unit_length;
  else
    parameters.s0 = parameters.sigma * unit_length;
  return parameters;
}

std::string why_invalid(const Parameters& p) {
  if (!positive(p.v0)) return refuse("v0", p.v0, "a finite speed > 0 m/s");
  if (!positive(p.tc)) return refuse("tc", p.tc, "a finite time > 0 s");
  if (!not_negative(p.s0)) return refuse("s0", p.s0, "a finite length >= 0 m");
  if (!not_negative(p.sigma)) return refuse("sigma", p.sigma, "finite and >= 0 (sigma = s0/(v0 tc))");
  if (!positive(p.epsilon) || p.epsilon > 1.0) return refuse("epsilon", p.epsilon, "> 0 and <= 1");
  if (!positive(p.d)) return refuse("d", p.d, "a finite length > 0 m");
  if (p.N < 1 || p.N > max_beads)
    return fmt::format("N = {} is not allowed: it must be a whole number from 1 to {}.", p.N, max_beads);
  if (!within(p.steps_per_tc, 2.0, 1e6)) return refuse("steps_per_tc", p.steps_per_tc, "from 2 to 1e6");
  if (!within(p.tolerance, 1e-15, 0.1)) return refuse("tolerance", p.tolerance, "from 1e-15 to 0.1");
  return {};
}

}  // namespace sigmasweep
