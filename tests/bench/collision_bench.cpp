// Time and error of one tuple by method: N = 10, eps = 0.9, the sigma of Fig. 2(a)'s transition. All methods run side
// by side in one process; compare them as ratios. `error` is |eps_eff - reference|, the reference computed in 113 bits.
// Then periods of a vibrated column, Fig. 7's and a clustered one, down to contact times that are 1e-6 periods:
// `contacts` a period, and the time for each.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "assembly/energies.hpp"
#include "base/quad.hpp"
#include "sigmasweep/model/names.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/exact/linear/collision.hpp"
#include "solve/exact/linear/side_by_side/batch.hpp"
#include "solve/exact/linear/side_by_side/lanes/advance.hpp"
#include "solve/fixed_step/column/collision.hpp"
#include "support/parameters.hpp"

namespace {

using namespace sigmasweep;

constexpr double sigmas[] = {0.0, 0.01, 0.1, 0.3, 1.0, 2.0, 10.0};

Parameters tuple(double sigma) { return soft_column({.v0 = 0.2, .tc = 1e-5, .sigma = sigma, .epsilon = 0.9, .N = 10}); }

double reference(const Parameters& p) {
  static std::map<double, double> known;
  if (const auto found = known.find(p.sigma); found != known.end()) return found->second;
  RunLimits to_the_end;
  to_the_end.settle = 0.0;
  const auto outcome = exact_collision<Quad>(reduced_column<Quad>(p), to_the_end);
  return known[p.sigma] = static_cast<double>(energies<Quad>(outcome.velocity, Quad(1)).eps_eff);
}

void report_error(benchmark::State& state, const Parameters& p, double eps_eff) {
  state.counters["error"] = std::abs(eps_eff - reference(p));
}

/// As a sweep runs it: with its error bar.
void exact(benchmark::State& state, double sigma, double tolerance) {
  Parameters p = tuple(sigma);
  p.tolerance = tolerance;
  SimulationResult c;
  for (auto _ : state) benchmark::DoNotOptimize(c = simulate(p));
  report_error(state, p, c.eps_eff);
  state.counters["bar"] = c.eps_eff_error;
}

/// The same from contact to contact in one column alone, and among 64 like ones side by side: the time a column.
void alone(benchmark::State& state, double sigma) {
  const Parameters p = tuple(sigma);
  SimulationResult c;
  for (auto _ : state) benchmark::DoNotOptimize(c = simulate_exact(p));
  report_error(state, p, c.eps_eff);
}
void columns_side_by_side(benchmark::State& state, double sigma, int lanes) {
  const std::vector<Parameters> tuples(64, tuple(sigma));
  std::vector<SimulationResult> results(tuples.size());
  for (auto _ : state) simulate_side_by_side(tuples, results, lanes);
  report_error(state, tuples[0], results[0].eps_eff);
  state.counters["a_column"] = benchmark::Counter(
      static_cast<double>(tuples.size()), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// The bare scheme at tc/steps, without the error bar that a sweep adds.
void fixed(benchmark::State& state, Integrator integrator, double sigma, double steps) {
  const Parameters p = tuple(sigma);
  const Column<double> column = reduced_column<double>(p);
  Outcome<double> outcome;
  for (auto _ : state) benchmark::DoNotOptimize(outcome = fixed_step_collision(column, integrator, 1.0 / steps));
  report_error(state, p, energies<double>(outcome.velocity, 1.0).eps_eff);
}

/// Periods of a vibrated column.
void vibrated(benchmark::State& state, double epsilon, double alpha, double tc, Integrator integrator) {
  Parameters p;
  p.geometry = Geometry::vibrated_column;
  p.epsilon = epsilon;
  p.alpha = alpha;
  p.tc = tc;
  p.integrator = integrator;
  p.periods = 30;
  p.transient = 0;
  p = completed(p);
  SimulationResult c;
  for (auto _ : state) benchmark::DoNotOptimize(c = simulate(p));
  const auto contacts = static_cast<double>(c.contacts);
  state.counters["contacts"] = contacts / static_cast<double>(p.periods);
  state.counters["each"] =
      benchmark::Counter(contacts, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

}  // namespace

int main(int argc, char** argv) {
  for (double sigma : sigmas) {
    const std::string at = "/sigma:" + std::to_string(sigma);
    for (const double tolerance : {1e-3, 1e-10})
      benchmark::RegisterBenchmark(("exact/" + std::to_string(int(std::log10(tolerance))) + at).c_str(), exact, sigma,
                                   tolerance)
          ->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark(("alone" + at).c_str(), alone, sigma)->Unit(benchmark::kMicrosecond);
    for (const int lanes : {1, 4, 8}) {
      if (lanes > side_by_side::widest()) continue;
      benchmark::RegisterBenchmark((fmt::format("side_by_side/{}", lanes) + at).c_str(), columns_side_by_side, sigma,
                                   lanes)
          ->Unit(benchmark::kMicrosecond);
    }
    for (auto integrator : {Integrator::gear5, Integrator::verlet, Integrator::rk4})
      for (int steps : {50, 100, 1000}) {
        const std::string name = std::string(name_of(integrator)) + "/tc:" + std::to_string(steps) + at;
        benchmark::RegisterBenchmark(name.c_str(), fixed, integrator, sigma, double(steps))
            ->Unit(benchmark::kMicrosecond);
      }
  }
  for (const auto& [epsilon, alpha] : {std::pair(0.92, 4.0), std::pair(0.6, 2.0)})
    for (const double tc : {1e-4, 1e-5, 1e-6, 1e-7})
      for (const auto integrator : {Integrator::exact, Integrator::verlet}) {
        if (integrator != Integrator::exact && tc < 1e-5) continue;  // seconds
        const std::string name =
            fmt::format("vibrated/{}/eps:{}/alpha:{}/tc:{}", name_of(integrator), epsilon, alpha, tc);
        benchmark::RegisterBenchmark(name.c_str(), vibrated, epsilon, alpha, tc, integrator)
            ->Unit(benchmark::kMillisecond);
      }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
