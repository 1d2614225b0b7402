// Lattices of discs: what a contact costs, by the number of beads and by sigma, from event to event and by fixed steps.
// `each`: time a contact that opened. `per_tc`: the same for a contact and the tc that it lasts: the more rows there
// are, the longer are those below closed.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdint>

#include "assembly/lattice.hpp"
#include "sigmasweep/model/names.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/exact/lattice/collision.hpp"
#include "solve/fixed_step/lattice/collision.hpp"
#include "support/parameters.hpp"

namespace {

using namespace sigmasweep;

Parameters scene(std::int64_t rows, std::int64_t columns, double sigma) {
  Parameters p = lattice_of_discs(rows, columns, 0.9, sigma);
  p.random_separation = Flag::yes;
  return p;
}

void count(benchmark::State& state, std::uint64_t contacts, double contact_time = 0.0) {
  state.counters["contacts"] = static_cast<double>(contacts);
  state.counters["each"] = benchmark::Counter(
      static_cast<double>(contacts), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  if (contact_time > 0.0)
    state.counters["per_tc"] =
        benchmark::Counter(contact_time, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// One run, without the second one for an error bar.
void from_event_to_event(benchmark::State& state, std::int64_t rows, std::int64_t columns, double sigma) {
  const auto lattice = reduced_lattice<double>(scene(rows, columns, sigma));
  LatticeOutcome<double> outcome;
  for (auto _ : state) outcome = lattice_collision(lattice, 1e-7);
  count(state, outcome.contacts, outcome.contact_time);
}

void by_fixed_steps(benchmark::State& state, std::int64_t rows, std::int64_t columns, double sigma,
                    Integrator integrator) {
  const auto lattice = reduced_lattice<double>(scene(rows, columns, sigma));
  std::uint64_t contacts = 0;
  for (auto _ : state) contacts = fixed_step_lattice_collision(lattice, integrator, 0.01).contacts;
  count(state, contacts);
}

/// Periods of a vibrated container, 5 rows of 8 beads.
void vibrated(benchmark::State& state, double tc, Integrator integrator) {
  const Parameters p = vibrated_lattice({.tc = tc,
                                         .s0 = 1e-5,
                                         .epsilon = 0.8,
                                         .alpha = 3.0,
                                         .periods = 4,
                                         .transient = 0,
                                         .rows = 5,
                                         .columns = 8,
                                         .integrator = integrator,
                                         .side_walls = SideWalls::fixed,
                                         .random_separation = Flag::yes});
  std::uint64_t contacts = 0;
  for (auto _ : state) contacts = simulate(p).contacts;
  count(state, contacts);
}

}  // namespace

int main(int argc, char** argv) {
  for (const auto& [rows, columns] : {std::pair(10, 13), std::pair(20, 20), std::pair(40, 40), std::pair(100, 100)})
    benchmark::RegisterBenchmark(fmt::format("lattice/exact/sigma:1/N:{}", rows * columns).c_str(), from_event_to_event,
                                 rows, columns, 1.0)
        ->Unit(benchmark::kMillisecond);
  for (const double sigma : {0.01, 0.1, 10.0, 1e4})
    benchmark::RegisterBenchmark(fmt::format("lattice/exact/sigma:{}/N:130", sigma).c_str(), from_event_to_event, 10,
                                 13, sigma)
        ->Unit(benchmark::kMillisecond);
  for (const auto integrator : {Integrator::gear5, Integrator::verlet, Integrator::rk4})
    benchmark::RegisterBenchmark(fmt::format("lattice/{}/tc:100/sigma:1/N:130", name_of(integrator)).c_str(),
                                 by_fixed_steps, 10, 13, 1.0, integrator)
        ->Unit(benchmark::kMillisecond);
  for (const double tc : {1e-3, 1e-4, 1e-5})
    for (const auto integrator : {Integrator::exact, Integrator::verlet})
      benchmark::RegisterBenchmark(fmt::format("vibrated-lattice/{}/tc:{}", name_of(integrator), tc).c_str(), vibrated,
                                   tc, integrator)
          ->Unit(benchmark::kMillisecond);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
