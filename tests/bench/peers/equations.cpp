#include "bench/peers/equations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "assembly/energies.hpp"

namespace sigmasweep::peers {
namespace {

std::array<double, beads> velocities(const State& y) {
  std::array<double, beads> v;
  double below = 0.0;
  for (std::size_t k = 0; k < beads; ++k) v[k] = below -= y[beads + k];
  return v;
}

}  // namespace

State at_start(double sigma) {
  State y{};
  std::fill_n(y.begin(), beads, -sigma);
  y[beads] = 1.0;
  return y;
}

ContactForce::ContactForce(double eps)
    : K(0.5 * (std::numbers::pi * std::numbers::pi + std::log(eps) * std::log(eps))), C(-std::log(eps)) {}

double eps_eff(const State& y) {
  const auto v = velocities(y);
  return energies<double>(v, 1.0).eps_eff;
}

bool is_over(const State& y, double settle) {
  const auto v = velocities(y);
  return residual_dissipation<double>(v, 1.0) <= settle;
}

double time_to_closing(const State& y) {
  double first = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < beads; ++k)
    if (y[beads + k] > 0.0) first = std::min(first, std::max(0.0, -y[k] / y[beads + k]));
  return first;
}

}  // namespace sigmasweep::peers
