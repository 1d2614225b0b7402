#pragma once

#include <algorithm>
#include <cstdint>

#include "assembly/ground.hpp"
#include "assembly/lattice.hpp"
#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "solve/observer/lattice_samples.hpp"

namespace sigmasweep {

/// LatticeSamples of a vibrated lattice, whose solvers keep time within the plate's period and say when one is over.
class VibratedLatticeSamples {
 public:
  static constexpr bool observes = true;

  VibratedLatticeSamples(LatticeSamples& samples, double period) : samples_(samples), period_(period) {}

  template <class State>
  void until(double time, State&& state) {
    const double begun = static_cast<double>(periods_) * period_;
    samples_.until(begun + time, [&](double when, auto q, auto v) { state(std::min(when - begun, time), q, v); });
  }
  void end_period(double /*energy*/, double /*in*/, double /*lost*/) { ++periods_; }
  bool done() const { return samples_.done(); }

 private:
  LatticeSamples& samples_;
  double period_;
  std::int64_t periods_ = 0;
};

/// A lattice in a container that vibrates as a whole under gravity, at rest relative to it at the start, as given. As
/// follow_by_fixed_steps() for a column; watcher: LatticeStatistics or VibratedLatticeSamples. Work in is what the
/// container does: all of its walls move.
template <class Watcher>
LatticeOutcome<double> fixed_step_vibrated_lattice(const Lattice<double>& lattice, const Plate& plate,
                                                   Integrator integrator, double dt, Watcher& watcher,
                                                   ComputeBudget* budget = nullptr);

}  // namespace sigmasweep
