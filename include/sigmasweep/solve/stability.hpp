#pragma once

#include <vector>

#include "sigmasweep/scene/parameters.hpp"
#include "sigmasweep/solve/column.hpp"

/// Whether a scheme of fixed step is stable, from the theory of linear maps: no collision is computed for it.
namespace sigmasweep {

/// A damped mode x'' + c x' + k x = 0 with time in steps: k = (omega dt)^2, c = 2 zeta omega dt.
struct Mode {
  double k = 0.0, c = 0.0;
};

/// The factor that a step of `integrator` (gear5, verlet, rk4) multiplies the mode's amplitude with in the end: the
/// spectral radius of the map that the step is. k, c >= 0. Error 1e-9.
double growth_per_step(Integrator integrator, const Mode& mode);

/// That map, row by row: of (x, x') for rk4; of (x, x', x'') for verlet; of x^(n)/n!, n = 0 to 5, for gear5.
std::vector<double> step_map(Integrator integrator, const Mode& mode);

/// The stiffest mode of the column with all contacts closed. Equal beads and the paper's wall: k = lambda K dt^2,
/// c = lambda C dt, lambda = 2 + 2 cos(2 pi/(2N + 1)); others: upper bounds of both (Gershgorin). For laws that are not
/// linear springs and dashpots are those of a small motion about the overlap x that a bead has when the wall has just
/// brought it to rest without damping, K (1 + beta) x^beta and C x^gamma.
Mode stiffest_mode(const Column<double>& column, double dt);

/// Growth up to which a column counts as stable: gear5 adds a little even where it is of use.
inline constexpr double most_stable_growth = 1.05;

/// What the scheme makes of the stiffest mode's amplitude in N tc, about the duration of a column's collision; may be
/// infinite. `dt` in the column's units.
double predicted_growth(const Column<double>& column, Integrator integrator, double dt);
bool is_stable(const Column<double>& column, Integrator integrator, double dt);
/// The same in one tc, whatever N is.
double growth_in_a_contact(const Column<double>& column, Integrator integrator, double dt);

/// Of a tuple with a fixed-step integrator and its steps_per_tc > 0. Strong damping by laws that are not linear takes
/// time, up to 0.1 s: see reduced_column().
double predicted_growth(const Parameters& parameters);
bool is_stable(const Parameters& parameters);

}  // namespace sigmasweep
