#include "bench/peers/own_methods.hpp"

#include <fmt/format.h>

#include <utility>

#include "assembly/energies.hpp"
#include "sigmasweep/model/names.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/fixed_step/column/collision.hpp"

namespace sigmasweep::peers {
namespace {

constexpr double tolerances[] = {1e-4, 1e-6, 1e-8, 1e-10, 1e-12};
constexpr int steps_per_tc[] = {20, 50, 100, 200, 500, 1000, 2000};

double value(const SimulationResult& result) { return is_success(result.status) ? result.eps_eff : result.nan; }

std::vector<Parameters> parameters_of(std::span<const Tuple> tuples, double tolerance) {
  std::vector<Parameters> all;
  for (const Tuple& tuple : tuples) all.push_back(tuple.parameters);
  for (Parameters& p : all) p.tolerance = tolerance;
  return all;
}

Method exact(double tolerance) {
  const auto prepare = [tolerance](std::span<const Tuple> tuples) -> Run {
    return [all = parameters_of(tuples, tolerance)](std::span<double> found) {
      for (std::size_t i = 0; i < all.size(); ++i) found[i] = value(simulate(all[i]));
    };
  };
  return {.name = "exact", .setting = fmt::format("{:.0e}", tolerance), .prepare = prepare};
}

Method exact_side_by_side(double tolerance) {
  const auto prepare = [tolerance](std::span<const Tuple> tuples) -> Run {
    return [all = parameters_of(tuples, tolerance),
            results = std::vector<SimulationResult>(tuples.size())](std::span<double> found) mutable {
      simulate_many(all, results);
      for (std::size_t i = 0; i < all.size(); ++i) found[i] = value(results[i]);
    };
  };
  return {.name = "exact, side by side",
          .setting = fmt::format("{:.0e}", tolerance),
          .prepare = prepare,
          .side_by_side = true};
}

/// The wall is further away by a fraction of the distance that the column flies in a step: the step's phase at the
/// first contact.
Method fixed_step(Integrator integrator, int steps) {
  const double dt = 1.0 / steps;
  const auto prepare = [integrator, dt](std::span<const Tuple> tuples) -> Run {
    std::vector<Column<double>> columns;
    for (const Tuple& tuple : tuples) {
      Column<double>& column = columns.emplace_back(reduced_column<double>(tuple.parameters));
      column.gaps.assign(column.contacts(), column.gap);
      column.gaps[0] += tuple.phase * dt * column.speed;
    }
    return [integrator, dt, columns = std::move(columns)](std::span<double> found) {
      for (std::size_t i = 0; i < columns.size(); ++i) {
        const Outcome<double> outcome = fixed_step_collision(columns[i], integrator, dt);
        found[i] = is_success(outcome.status) ? energies<double>(outcome.velocity, columns[i].speed).eps_eff
                                              : SimulationResult::nan;
      }
    };
  };
  return {.name = std::string(name_of(integrator)), .setting = fmt::format("tc/{}", steps), .prepare = prepare};
}

}  // namespace

std::vector<Method> own_methods() {
  std::vector<Method> methods;
  for (const double tolerance : tolerances) methods.push_back(exact(tolerance));
  for (const double tolerance : tolerances) methods.push_back(exact_side_by_side(tolerance));
  for (const auto integrator : {Integrator::gear5, Integrator::verlet, Integrator::rk4, Integrator::leapfrog})
    for (const int steps : steps_per_tc) methods.push_back(fixed_step(integrator, steps));
  return methods;
}

}  // namespace sigmasweep::peers
