#pragma once

#include <cstdint>

#include "assembly/column.hpp"
#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"
#include "solve/outcome.hpp"
#include "solve/run_limits.hpp"

/// The default integrator of laws F = K x^(1+beta) + C x^gamma x' that are not linear: from contact event to contact
/// event with the Runge-Kutta scheme DOP853 of order 8 (numerics/dormand_prince.hpp). Where a contact has just closed,
/// or is about to open, the force is not smooth in time but in s = x^(1/q), and s is the independent variable.
namespace sigmasweep {

class Samples;

/// One collision of a column in reduced units (speed and tc are 1). `accuracy`: local error of a step, in units of the
/// speed and of speed times tc. Real is double or long double. End::settled or separated with Status::ok;
/// Status::event_limit, non_finite. Limits of its own: 100,000 + 20 N^2 contacts; 5e7 contacts propagated, summed over
/// all trial steps. `restitution_off`: part by which restitutions of isolated contacts are made smaller, of a twin run.
template <class Real>
Outcome<Real> nonlinear_collision(const Column<Real>& column, double accuracy = 1e-12, const RunLimits& limits = {},
                                  double restitution_off = 0.0);

/// The tuple's collision with an error bar: the difference between two runs, one with local errors ten times those of
/// the other, and what is left to dissipate. Where that is above the tolerance finer pairs of runs follow, in long
/// double in the end; status tolerance_missed with the smallest error found where none meets the tolerance.
SimulationResult simulate_nonlinear(const Parameters& parameters, ComputeBudget* budget = nullptr);

/// The run in doubles, seen by the samples and over with the last of them. The clock starts at the first contact with
/// the wall.
void observe_nonlinear(const Column<double>& column, Samples& samples);

}  // namespace sigmasweep
