#pragma once

#include "sigmasweep/model/parameters.hpp"

/// What makes an error bar of a column's disturbance, for columns alone and side by side.
namespace sigmasweep::error_bar {

/// Linearised disturbances of a column, independent random draws of what the true error is another draw of. Of normal
/// draws with equal variance a new one exceeds f times the larger of two others with the chance (2/pi) asin(1/(1 +
/// f^2)): one in a thousand for f = 25, and for f = 637 if there were one other. The disturbances of random tuples are
/// about 3 times as large as the errors, so that a third of 25 would do; a little more is taken.
inline constexpr int draws = 2;
inline constexpr double safety = 10.0;
/// Roundings of eps_eff that the disturbances do not know of: from velocities to energies, and the drift of the energy,
/// in roundings a step, as a step's rounded coefficients are the same in many steps.
inline constexpr double last_roundings = 8.0, drift = 0.2;
/// Where masses differ, a contact's impulse is shared out in rounded parts: roundings a contact and bead.
inline constexpr double shares = 3.0;

/// What these roundings are relative to. K_over_m and D_n near critical damping: restitution may be small, and has the
/// roundings of numbers of order one.
inline double size(const Parameters& p, double eps_eff) { return p.K_over_m > 0.0 ? 1.0 : eps_eff; }

}  // namespace sigmasweep::error_bar
