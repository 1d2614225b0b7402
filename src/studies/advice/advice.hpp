#pragma once

#include <optional>
#include <vector>

#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"

namespace sigmasweep {

/// A column of soft beads beside hard ones: whether its contacts are too soft, and what its time steps cost.
struct Advice {
  Parameters tuple;        ///< complete; a column under the linear law, from event to event
  double mass = 0.0;       ///< of a bead, kg
  double stiffness = 0.0;  ///< spring of a pair, N/m
  double dashpot = 0.0;    ///< of a pair: force over closing speed, N s/m
  double wall_stiffness = 0.0, wall_dashpot = 0.0;
  SimulationResult soft, hard;
  /// From this sigma on eps_eff differs from that of hard spheres by at most `near` of it; 0: everywhere; none: nowhere
  /// up to largest_sigma.
  std::optional<double> hard_from;
  struct Step {
    int steps_per_tc = 0;
    double eps_eff = 0.0, error = 0.0;  ///< error: the difference from `soft`
    bool stable = true;
  };
  std::vector<Step> steps;  ///< velocity Verlet

  static constexpr double near = 0.05, largest_sigma = 1e4;
  /// The contact time, s, at which gap and speed give sigma = hard_from; none where there is no such sigma, or no gap.
  std::optional<double> hard_tc() const;
  bool is_near_hard() const;
};

/// The spring of a pair of beads of this mass, N/m, with contact time tc, s, and restitution epsilon:
/// K = m ((pi/tc)^2 + (ln(eps)/tc)^2)/2, from Eqs. (5) to (7) with the reduced mass m/2; and tc of a spring.
double stiffness_of(double mass, double tc, double epsilon);
double tc_of(double mass, double stiffness, double epsilon);

/// Computes it. `tuple` is a complete column of soft beads under the linear law.
Advice advise(const Parameters& tuple, double mass);

}  // namespace sigmasweep
