#pragma once

#include <cstdint>

#include "sigmasweep/scene/collision.hpp"
#include "sigmasweep/scene/parameters.hpp"
#include "sigmasweep/solve/column.hpp"

/// The default integrator of the linear law: between two contact events the column is a linear system with constant
/// coefficients, so it is propagated to rounding error, and the events are found on the solution's own polynomial.
namespace sigmasweep {

struct ExactOptions {
  double settle = 1e-13;          ///< stop once later collisions can change eps_eff by less than this; 0: never
  std::uint64_t event_limit = 0;  ///< contact events before giving up; 0: 100,000 + 20 N^2
};

/// One collision. Real is double, long double or Quad; the result is good to a few roundings of Real times the
/// condition of the problem. End::settled or separated with Status::ok, or Status::event_limit, non_finite.
template <class Real>
Outcome<Real> exact_collision(const Column<Real>& column, const ExactOptions& options = {});

/// The tuple's collision with an error bar. Runs in double together with a twin that is disturbed in the last bits;
/// what the two disagree by, and what is left to dissipate, make eps_eff_error. Where that is above the tolerance
/// (long bounce sequences amplify any error) the wider types follow; status tolerance_missed where even those fail.
Collision simulate_exact(const Parameters& parameters);

}  // namespace sigmasweep
