#pragma once

#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"

/// A column under gravity, at rest relative to a plate when that begins to move as z0(t) = A0 sin(2 pi f t), Eq. (1);
/// Sec. V. Each of these follows it for all periods and fills in SimulationResult::vibration, contacts, end and status,
/// of soft spheres also x_max.
namespace sigmasweep {

SimulationResult simulate_vibrated(const Parameters& parameters, ComputeBudget* budget = nullptr);
SimulationResult simulate_vibrated_soft_spheres(const Parameters& parameters, ComputeBudget* budget = nullptr);
/// Of a lattice in a vibrated container, soft spheres.
SimulationResult simulate_vibrated_lattice(const Parameters& parameters, ComputeBudget* budget = nullptr);

/// The same of soft spheres by a scheme of order 8 with local errors of `accuracy`, in units of the plate's largest
/// speed (and that times tc): finer or coarser than simulate_vibrated(), and for columns under the linear law another
/// method.
SimulationResult vibrated_by_steps(const Parameters& parameters, double accuracy, ComputeBudget* budget = nullptr);

/// Bounces on the plate end in finite time: beads whose next bounces would be over within 1e-8 periods are at rest on
/// it, and such columns, like others that collapse, are Status::collapsed. With EdRule::tc there is no such end: a bead
/// goes on in hops of about tc, so a period takes some 1/(f tc) collisions a bead. Status::event_limit after 2e7
/// collisions in one period, as of elastic beads that the plate only just lifts.
SimulationResult simulate_vibrated_hard_spheres(const Parameters& parameters, ComputeBudget* budget = nullptr);

}  // namespace sigmasweep
