#pragma once

#include <cstdint>
#include <span>

#include "assembly/column.hpp"
#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"
#include "solve/outcome.hpp"
#include "solve/run_limits.hpp"

/// The default integrator of the linear law: between two contact events the column is a linear system with constant
/// coefficients, so it is propagated to rounding error, and the events are found on the solution's own polynomial.
namespace sigmasweep {

class Samples;

/// One collision. Real is double, long double or Quad; the result is good to a few roundings of Real times the
/// condition of the problem. End::settled or separated with Status::ok, or Status::event_limit, non_finite. Limits of
/// its own: 100,000 + 20 N^2 contacts, and always 8 times as many steps as contacts; 1e8 contacts propagated, summed
/// over the steps, which are minutes.
template <class Real>
Outcome<Real> exact_collision(const Column<Real>& column, const RunLimits& limits = {});

/// The same from any start with all contacts open: gaps as in `column`, that to the wall included, and the speeds at
/// which they close (< 0: open), contact by contact; column.speed is only the unit. Time 0 is the start.
template <class Real>
Outcome<Real> exact_collision_from(const Column<Real>& column, std::span<const Real> rates,
                                   const RunLimits& limits = {});

/// The tuple's collision with an error bar, by the cheapest way that keeps the tolerance. Two linearised disturbances,
/// fed with the rounding errors of every step, run beside the column; the size of the larger one, and what is left to
/// dissipate, make eps_eff_error. For tolerances of 1e-4 and above short series are tried first. Where the bar of the
/// full ones is above the tolerance, two twins of the column that differ in the thirteenth digit have the second say,
/// and then the wider types, if about a second is enough for them. Status tolerance_missed with the smallest error
/// found where none meets the tolerance. contacts, t_k and x_max are those up to the stop at `settle` = tolerance/1000.
SimulationResult simulate_exact(const Parameters& parameters, ComputeBudget* budget = nullptr);

/// The run in doubles, seen by the samples and over with the last of them. The clock starts at the first contact with
/// the wall.
void observe_exact(const Column<double>& column, Samples& samples);

}  // namespace sigmasweep
