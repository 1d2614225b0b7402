#pragma once

#include "sigmasweep/model/parameters.hpp"

/// Parts of the predicted CPU time that several solvers have in common. The coefficients, here and in the solvers'
/// files, were fitted to single tuples (N = 1 to 200, epsilon = 0.6 to 1, all sigma) on a 2-core x86-64 with AVX2.
/// Predictions are good to a factor of about 3 where the exact solver stays in double precision. The time for chaotic
/// or collapsing tuples is not predicted. To calibrate: compare run_time with predicted_time in /timings.
namespace sigmasweep::cost {

/// Of any tuple, s: reducing the column, summing up.
inline constexpr double tuple = 0.8e-6;

/// sigma, but at most 1e12: no inf/inf, no NaN, and no time changes up there.
double bounded_sigma(const Parameters& p);

/// Number of contacts apart from those of the wave through the touching column: for sigma above 1 all N^2 of hard
/// spheres (N(N+1)/2 without losses); for sigma << 1 the beads fly apart after the wave and hardly meet again.
double later_contacts(double N, double sigma);

/// Coefficients of a column's solver that goes from contact event to contact event, s.
struct EventCosts {
  double dense_bead;      ///< the wave through the touching column, each bead
  double dense_pair;      ///< the same, each bead for each bead that moves with it
  double contact;         ///< a contact that overlaps no other in time
  double shared_contact;  ///< a contact that overlaps others, each bead
};
/// Time for the collision of a column, s.
double of_collision(const Parameters& p, const EventCosts& costs);

/// Number of contacts of a vibrated column. It goes with N^2, and the stronger the agitation, the longer beads fly from
/// contact to contact.
double contacts_on_plate(const Parameters& p);

/// Time for a vibrated column, s, each of whose contacts costs `contact`.
double of_periods(const Parameters& p, double contact);

/// Time for the collision of a lattice from event to event, without `tuple`, s. Beads in contact are moved by steps, in
/// all directions; free flight costs no time. Good to a factor of 3 for 8 to 1600 beads; 10^4 take five times as long.
double of_lattice_events(const Parameters& p);

}  // namespace sigmasweep::cost
