#pragma once

#include <cmath>
#include <limits>
#include <span>

#include "assembly/column.hpp"
#include "assembly/energies.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"
#include "solve/outcome.hpp"

namespace sigmasweep {

/// The tuple's result in SI units, without eps_eff_error, from an outcome of a column or a lattice in reduced units and
/// the energies of its velocities. All numbers are NaN if there is no result.
template <class AnyOutcome, class Real>
SimulationResult to_si_result(const Energies<Real>& e, const AnyOutcome& outcome, const Parameters& parameters) {
  SimulationResult c;
  c.end = outcome.end;
  c.status = outcome.status;
  if (!is_success(outcome.status) && outcome.status != Status::tolerance_missed) return c;
  c.eps_eff = static_cast<double>(e.eps_eff);
  c.Er_Ef = static_cast<double>(e.Er_Ef);
  c.Er_E0 = static_cast<double>(e.Er_E0);
  c.v_cm = static_cast<double>(e.v_cm);
  c.t_k = static_cast<double>(outcome.t_k) * parameters.tc;
  c.x_max = static_cast<double>(outcome.x_max) * (parameters.v0 * parameters.tc);
  c.contacts = outcome.contacts;
  for (const double number : {c.eps_eff, c.Er_Ef, c.Er_E0, c.v_cm, c.t_k, c.x_max})
    if (!std::isfinite(number)) {
      SimulationResult nothing;
      nothing.status = Status::non_finite;
      return nothing;
    }
  return c;
}

/// The result of a column in SI units; masses as in Column.
template <class Real>
SimulationResult to_si_result(const Outcome<Real>& outcome, const Parameters& parameters,
                              std::span<const Real> mass = {}) {
  return to_si_result(energies<Real>(std::span<const Real>(outcome.velocity), Real(1), mass), outcome, parameters);
}

/// Sets v_cm_error and Er_Ef_error from the error of the final velocities, a mass-weighted root mean square over v0.
/// v_cm is one of their components. E_r/E_f is the squared sine of an angle, that of all velocities and of equal ones,
/// which is off by at most asin(error/eps_eff) = phi, and sin^2(a + phi) - sin^2(a) = sin(phi) sin(2 a + phi).
inline void set_errors_of_motion(SimulationResult& c, double velocity_error) {
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  const auto at_most_one = [](double error) { return error <= 1.0 ? error : 1.0; };
  const double phi = std::asin(at_most_one(velocity_error / c.eps_eff));
  c.v_cm_error = at_most_one(velocity_error + 0.5 * rounding * std::fabs(c.v_cm));
  c.Er_Ef_error =
      at_most_one(phi * (2.0 * std::sqrt(c.Er_Ef * std::fmax(1.0 - c.Er_Ef, 0.0)) + phi) + rounding * c.Er_Ef);
}

/// How far velocities may still change, over v0, where eps_eff can still fall by `decrease`. The final velocities and
/// the present ones lie within the root of the energy that goes then, (2 eps_eff + decrease) decrease at most, around
/// the projection that EnergyBalance::outlook() speaks of.
inline double velocity_left(double eps_eff, double decrease) {
  return 2.0 * std::sqrt(decrease * (2.0 * eps_eff + decrease));
}

/// The result with its error bar. Its status becomes tolerance_missed if the error is larger than the tolerance.
inline SimulationResult with_error(SimulationResult c, double eps_eff_error, double tolerance) {
  if (!std::isfinite(c.eps_eff)) return c;
  c.eps_eff_error = eps_eff_error;
  if (!(eps_eff_error <= tolerance)) c.status = Status::tolerance_missed;
  return c;
}

}  // namespace sigmasweep
