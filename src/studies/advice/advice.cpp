#include "studies/advice/advice.hpp"

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <numbers>

#include "assembly/column.hpp"
#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/solve/simulate.hpp"

namespace sigmasweep {
namespace {

constexpr std::array usual_steps{10, 20, 50, 100, 200};

Parameters with_sigma(Parameters p, double sigma) {
  p.sigma = sigma;
  return complete(p, GapParameter::sigma);
}

Parameters hard_spheres(Parameters p) {
  p.method = Method::ed;
  return complete(p, GapParameter::s0);
}

/// How far eps_eff is from that of hard spheres, beyond what is near: positive where it is too far.
double beyond(const SimulationResult& soft, double hard) { return std::abs(soft.eps_eff - hard) - Advice::near * hard; }

/// The smallest sigma from which on everything is near: by 20 values a decade, then by bracketing.
std::optional<double> near_from(const Parameters& tuple, double hard) {
  constexpr int a_decade = 20, decades = 8;
  std::vector<Parameters> tuples;
  std::vector<double> sigmas;
  for (int k = 0; k <= a_decade * decades; ++k) {
    sigmas.push_back(Advice::largest_sigma * std::pow(10.0, static_cast<double>(k) / a_decade - decades));
    tuples.push_back(with_sigma(tuple, sigmas.back()));
  }
  std::vector<SimulationResult> results(tuples.size());
  simulate_many(tuples, results);
  std::size_t first = results.size();
  while (first > 0 && beyond(results[first - 1], hard) <= 0.0) --first;
  if (first == results.size()) return std::nullopt;
  if (first == 0) return 0.0;
  const auto at = [&](double log_sigma) { return beyond(simulate(with_sigma(tuple, std::exp(log_sigma))), hard); };
  std::uintmax_t evaluations = 60;
  const auto [low, high] = boost::math::tools::toms748_solve(
      at, std::log(sigmas[first - 1]), std::log(sigmas[first]), beyond(results[first - 1], hard),
      beyond(results[first], hard), [](double a, double b) { return std::abs(b - a) < 1e-6; }, evaluations);
  return std::exp(std::max(low, high));
}

Advice::Step verlet(const Parameters& tuple, int steps_per_tc, const SimulationResult& exact) {
  Parameters p = tuple;
  p.integrator = Integrator::verlet;
  p.steps_per_tc = steps_per_tc;
  const SimulationResult result = simulate(p);
  const bool stable = is_success(result.status) && !(result.predicted_growth > 1.0);
  return {steps_per_tc, result.eps_eff, std::abs(result.eps_eff - exact.eps_eff), stable};
}

}  // namespace

double stiffness_of(double mass, double tc, double epsilon) {
  return mass / 2.0 * (std::pow(std::numbers::pi, 2) + std::pow(std::log(epsilon), 2)) / (tc * tc);
}

double tc_of(double mass, double stiffness, double epsilon) {
  return std::sqrt(mass / 2.0 * (std::pow(std::numbers::pi, 2) + std::pow(std::log(epsilon), 2)) / stiffness);
}

std::optional<double> Advice::hard_tc() const {
  if (!hard_from || !(*hard_from > 0.0) || !(tuple.s0 > 0.0)) return std::nullopt;
  return tuple.s0 / (tuple.v0 * *hard_from);
}

bool Advice::is_near_hard() const { return std::abs(soft.eps_eff - hard.eps_eff) <= near * hard.eps_eff; }

Advice advise(const Parameters& tuple, double mass) {
  const Column<double> column = si_column<double>(tuple);
  Advice advice{.tuple = tuple,
                .mass = mass,
                .stiffness = column.K * mass,
                .dashpot = column.C * mass,
                .wall_stiffness = column.K_wall * mass,
                .wall_dashpot = column.C_wall * mass,
                .soft = simulate(tuple),
                .hard = simulate(hard_spheres(tuple)),
                .hard_from = {},
                .steps = {}};
  if (std::isfinite(advice.hard.eps_eff)) advice.hard_from = near_from(tuple, advice.hard.eps_eff);
  for (const int steps : usual_steps) advice.steps.push_back(verlet(tuple, steps, advice.soft));
  return advice;
}

}  // namespace sigmasweep
