#pragma once

#include <algorithm>
#include <cstdint>

#include "assembly/ground.hpp"
#include "assembly/lattice.hpp"
#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "solve/observer/lattice_samples.hpp"
#include "solve/observer/lattice_statistics.hpp"

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

/// A lattice in a container that vibrates as a whole under gravity, at rest relative to it at the start, as given; by
/// steps of at most `dt`, as fixed_step_vibrated_column(). Work in is the container's: all of its walls move.
LatticeOutcome<double> fixed_step_vibrated_lattice(const Lattice<double>& lattice, const Plate& plate,
                                                   Integrator integrator, double dt, LatticeStatistics& statistics,
                                                   ComputeBudget* budget = nullptr);
/// The same with samples of the motion (vibrated_samples.cpp).
LatticeOutcome<double> fixed_step_vibrated_lattice(const Lattice<double>& lattice, const Plate& plate,
                                                   Integrator integrator, double dt, VibratedLatticeSamples& samples,
                                                   ComputeBudget* budget = nullptr);

}  // namespace sigmasweep
