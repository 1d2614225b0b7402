#pragma once

#include <cstdint>
#include <limits>

#include "sigmasweep/model/names.hpp"

namespace sigmasweep {

/// Why a tuple's computation ended.
enum class End : std::uint8_t {
  none,       ///< it did not end: see the status
  separated,  ///< no contact closed and no neighbouring pair, wall included, approaching
  settled,    ///< pairs still approach, but the energy they can dissipate is below the tolerance, and in the error
  periods,    ///< all periods of a plate are over
  quiet       ///< lattice: no contact has closed for a time of 2 N s0/v0, Sec. IV C
};
constexpr auto enumerator_names(End) {
  return names_up_to<End::quiet>("none", "separated", "settled", "periods", "quiet");
}

/// Whether a row holds a result, and if not, why. The names are stored in the table.
enum class Status : std::uint8_t {
  ok,
  collapsed,         ///< hard spheres: infinitely many collisions in finite time; finished as one cluster. A result.
  tolerance_missed,  ///< a result, but its estimated error is above the tolerance
  unstable,          ///< a fixed time step that is too long for the stiffest mode: no result
  event_limit,       ///< stopped after too many contact events: no result
  time_limit,        ///< stopped after too much computing time: no result
  non_finite,        ///< an infinity or NaN came up: no result
  failed,            ///< the solver threw: no result
  not_run,
  quarantined  ///< the process died twice while it was computed, and it is not tried again: no result
};
constexpr auto enumerator_names(Status) {
  return names_up_to<Status::quarantined>("ok", "collapsed", "tolerance_missed", "unstable", "event_limit",
                                          "time_limit", "non_finite", "failed", "not_run", "quarantined");
}

/// Whether a row with this status holds the result that was asked for.
constexpr bool is_success(Status status) { return status == Status::ok || status == Status::collapsed; }

/// Whether the same tuple has this status whenever and wherever it is computed.
constexpr bool is_reproducible(Status status) {
  return status != Status::time_limit && status != Status::not_run && status != Status::quarantined;
}

/// Results of beads on a vibrating plate, averaged over the periods after the transient. Powers and energies are
/// divided by the mass of all beads.
struct Vibration {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  double h_cm = nan;            ///< mean height of the centre of mass above the plate's middle position, m
  double h_cm_error = nan;      ///< its standard error, by block averages; NaN for a single period
  double h_cm_excess = nan;     ///< h_cm less its value at rest with the plate in the middle, m
  double separation = nan;      ///< mean gap between neighbours (overlaps count as negative), m
  double separation_max = nan;  ///< the largest one, m
  double E_r = nan;             ///< mean kinetic energy relative to the centre of mass, J/kg
  double cm_period = nan;       ///< period of the centre of mass, s; NaN: it does not repeat within 16/f
  double power_in = nan;        ///< mean power of the plate, W/kg
  double power_lost = nan;      ///< mean power lost in contacts, W/kg
  double imbalance = nan;       ///< work in less work lost and gain of energy, over max(work in, weight x plate's path)
};

/// The result of one tuple. A plain value of fixed size, sent and stored as it is. Where there is no result, every
/// number but predicted_growth and steps_used is NaN.
struct SimulationResult {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  double eps_eff = nan;        ///< sqrt(E_f/E_0), effective restitution
  double eps_eff_error = nan;  ///< estimate of its absolute error
  double Er_Ef = nan;          ///< E_r/E_f, E_r = 1/2 sum m_i (v_i - v_cm)^2 after the collision
  double Er_E0 = nan;          ///< E_r/E_0
  double v_cm = nan;           ///< final velocity of the centre of mass over v0
  double t_k = nan;            ///< from the first to the last contact with the wall, s (0 for hard spheres at s0 = 0)
  double x_max = nan;          ///< largest overlap of any contact, m (0 for hard spheres)
  /// Growth of the amplitude of the least stable mode in N tc (of lattices: in rows tc) with a fixed time step, by
  /// theory (stability.hpp); well above 1 where the step is too long.
  double predicted_growth = nan;
  double steps_used = nan;  ///< of fixed time steps: steps per tc, given or chosen for the tolerance
  Vibration vibration;      ///< of beads on a vibrating plate, which have besides it x_max and the following only
  /// Number of contacts that closed and opened again; of hard spheres, of collisions. A lower bound with End::settled,
  /// as later contacts, of next to no energy, are not computed, and with Status::collapsed, as there are infinitely
  /// many.
  std::uint64_t contacts = 0;
  End end = End::none;
  Status status = Status::not_run;
  double Er_Ef_error = nan;  ///< estimate of the absolute error of Er_Ef
  double v_cm_error = nan;   ///< estimate of the absolute error of v_cm
};

}  // namespace sigmasweep
