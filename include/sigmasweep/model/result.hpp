#pragma once

#include <cstdint>
#include <limits>

namespace sigmasweep {

/// Why a collision was considered over.
enum class End : std::uint8_t {
  none,       ///< it is not over: see the status
  separated,  ///< no contact closed and no neighbouring pair, wall included, approaching
  settled,    ///< pairs still approach, but what they can dissipate is below the tolerance, and in the error
  periods,    ///< vibrated: all periods of the plate are over
  quiet       ///< lattice: nothing has touched for a time of 2 N s0/v0, Sec. IV C
};

/// What a row of a table is worth. The names are stored in the table (names.hpp).
enum class Status : std::uint8_t {
  ok,
  collapsed,         ///< hard spheres: infinitely many collisions in finite time; finished as one cluster. A result.
  tolerance_missed,  ///< a result, but its estimated error is above the tolerance
  unstable,          ///< a fixed time step that is too long for the stiffest mode: no result
  event_limit,       ///< given up after too many contact events: no result
  time_limit,        ///< given up after too much computing time: no result
  non_finite,        ///< an infinity or NaN came up: no result
  failed,            ///< the solver threw: no result
  not_run,
  quarantined  ///< the process died twice while it was computed, and it is not tried again: no result
};

/// Whether a row with this status holds what was asked for.
constexpr bool is_success(Status status) { return status == Status::ok || status == Status::collapsed; }

/// Whether the same tuple has this status whenever and wherever it is computed.
constexpr bool is_reproducible(Status status) {
  return status != Status::time_limit && status != Status::not_run && status != Status::quarantined;
}

/// What vibrates, averaged over the periods after the transient. Powers and energies are over the mass of all beads.
struct Vibration {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  double h_cm = nan;            ///< mean height of the centre of mass above the plate's middle position, m
  double h_cm_error = nan;      ///< its standard error, by block averages; NaN for a single period
  double h_cm_excess = nan;     ///< h_cm less its value at rest with the plate in the middle, m
  double separation = nan;      ///< mean gap between neighbours (overlaps count as negative), m
  double separation_max = nan;  ///< the largest one, m
  double E_r = nan;             ///< mean kinetic energy relative to the centre of mass, J/kg
  double cm_period = nan;       ///< after which the centre of mass repeats its motion, s; NaN: not within 16/f
  double power_in = nan;        ///< mean power of the plate, W/kg
  double power_lost = nan;      ///< mean power lost in contacts, W/kg
  double imbalance = nan;       ///< work in less work lost and gain of energy, over max(work in, weight x plate's path)
};

/// What one collision of a column gave. A plain value of fixed size, sent and stored as it is.
/// Where there is no result every number is NaN, but for predicted_growth.
struct SimulationResult {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  double eps_eff = nan;        ///< sqrt(E_f/E_0), effective restitution
  double eps_eff_error = nan;  ///< estimate of its absolute error
  double Er_Ef = nan;          ///< E_r/E_f, E_r = 1/2 sum m_i (v_i - v_cm)^2 after the collision
  double Er_E0 = nan;          ///< E_r/E_0
  double v_cm = nan;           ///< final velocity of the centre of mass over v0
  double t_k = nan;            ///< from the first to the last contact with the wall, s (0 for hard spheres at s0 = 0)
  double x_max = nan;          ///< largest overlap of any contact, m (0 for hard spheres)
  /// Of a fixed time step: what it makes of the amplitude of the least stable mode in N tc, of lattices rows tc, from
  /// theory (stability.hpp); a good deal above 1 where the step is too long.
  double predicted_growth = nan;
  Vibration vibration;         ///< of what vibrates, of which nothing else is known than x_max and the following
  std::uint64_t contacts = 0;  ///< contacts that closed and opened again; for hard spheres collisions
  End end = End::none;
  Status status = Status::not_run;
};

}  // namespace sigmasweep
