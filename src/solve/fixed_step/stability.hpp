#pragma once

#include <cstdint>
#include <vector>

#include "assembly/column.hpp"
#include "assembly/lattice.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "solve/fixed_step/schemes/step_map.hpp"

/// Stability of schemes of fixed step, from the theory of linear maps, without computing a collision.
namespace sigmasweep {

/// Asymptotic growth of a mode's amplitude in a step of `integrator`, the spectral radius of the step's map. Time is in
/// steps; k, c >= 0. The error is 1e-9.
double growth_per_step(Integrator integrator, const Mode& mode);

/// A column or a lattice while all of its contacts are closed.
struct ClosedContacts {
  std::vector<Mode> modes;  ///< in the column's units of time; one of them is nearly the first to become unstable
  double tc = 1.0;
  double height = 1.0;  ///< N or rows; a collision lasts about `height` tc
};

/// The stiffest mode of a column. For equal beads and the paper's wall k = lambda K and c = lambda C with lambda = 2 +
/// 2 cos(2 pi/(2N + 1)); otherwise k and c are upper bounds (Gershgorin). For nonlinear laws spring and dashpot are
/// those of a small motion, K (1 + beta) x^beta and C x^gamma, about the largest overlap x of a bead that the wall
/// brings to rest without damping.
ClosedContacts closed_contacts(const Column<double>& column);

/// The modes of a lattice with the largest spring, dashpot, friction (D_t), and dashpot + friction. In an infinite
/// lattice of equal beads the three are s K, s C and r D_t, where s + r = 2 sum over the three bonds of (1 - cos): (s,
/// r) = (6, 2) is the stiffest mode, (2, 6) has the largest damping for D_t > C, and (9/2, 9/2) for D_t about C. In
/// finite lattices the modes are found by power iteration, with at most 40 rows and columns. Modes between them have up
/// to 3 % more damping.
///
/// The estimate is on the safe side, because a collision may not excite these modes: in a lattice without shifts all
/// columns move alike, discs that only touch are not in contact, and wide gaps leave few contacts closed at a time.
ClosedContacts closed_contacts(const Lattice<double>& lattice);

/// The modes of the tuple's column or lattice. On a plate the impact speed is the plate's largest speed. It takes up to
/// 0.1 s for strong damping by nonlinear laws (see reduced_column()), up to 0.05 s for a lattice.
ClosedContacts closed_contacts(const Parameters& parameters);

/// All numbers on which the stability of a tuple depends, except integrator and step: tuples with equal signatures have
/// the same closed contacts. For equal beads v0 and s0 do not matter.
using StabilitySignature = std::vector<std::uint64_t>;
StabilitySignature stability_signature(const Parameters& parameters);

/// Whether closed_contacts() searches the modes of a lattice of unequal beads, which takes up to 0.05 s.
bool has_searched_motions(const Parameters& parameters);

/// Largest growth that counts as stable. gear5 adds a little energy even at useful time steps.
inline constexpr double max_stable_growth = 1.05;

/// Growth of the most unstable mode's amplitude in `height` tc, about the duration of a collision; may be infinite.
/// `dt` is in the column's units.
double predicted_growth(const ClosedContacts& closed, Integrator integrator, double dt);
bool is_stable(const ClosedContacts& closed, Integrator integrator, double dt);
/// Growth of the most unstable mode's amplitude in one tc.
double growth_in_a_contact(const ClosedContacts& closed, Integrator integrator, double dt);

/// Growth for a tuple with an integrator of fixed step and steps_per_tc > 0.
double predicted_growth(const Parameters& parameters);
bool is_stable(const Parameters& parameters);

}  // namespace sigmasweep
