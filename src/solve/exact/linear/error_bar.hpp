#pragma once

#include "sigmasweep/model/parameters.hpp"

/// What makes an error bar of a column's disturbance, for columns alone and side by side.
namespace sigmasweep::error_bar {

/// One disturbance is one random draw of what the true error is another draw of: the factor makes it an error bar that
/// holds for 99.9 % of random tuples, at a median of about 30 times the true error.
inline constexpr double safety = 16.0;
/// Roundings of eps_eff that the disturbances do not know of: from velocities to energies, and the drift of the energy,
/// in roundings a step, as a step's rounded coefficients are the same in many steps.
inline constexpr double last_roundings = 8.0, drift = 0.2;

/// What these roundings are relative to. K_over_m and D_n near critical damping: restitution may be small, and has the
/// roundings of numbers of order one.
inline double size(const Parameters& p, double eps_eff) { return p.K_over_m > 0.0 ? 1.0 : eps_eff; }

}  // namespace sigmasweep::error_bar
