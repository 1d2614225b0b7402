#pragma once

#include <cstdint>
#include <vector>

#include "assembly/column.hpp"
#include "assembly/lattice.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "solve/fixed_step/schemes/step_map.hpp"

/// Whether a scheme of fixed step is stable, from the theory of linear maps: no collision is computed for it.
namespace sigmasweep {

/// The factor by which a step of `integrator` multiplies the amplitude of a mode in the end, time in steps: the
/// spectral radius of the step's map. k, c >= 0. Error 1e-9.
double growth_per_step(Integrator integrator, const Mode& mode);

/// A column or a lattice while all of its contacts are closed.
struct ClosedContacts {
  std::vector<Mode> modes;  ///< one of them is about the first to be unstable; in the column's units of time
  double tc = 1.0;
  double height = 1.0;  ///< beads above each other, N or rows: a collision lasts about so many tc
};

/// Of a column its stiffest mode. Equal beads and the paper's wall: k = lambda K, c = lambda C, lambda = 2 + 2 cos(2
/// pi/ (2N + 1)); others: upper bounds of both (Gershgorin). For laws that are not linear springs and dashpots are
/// those of a small motion about the overlap x that a bead has when the wall has just brought it to rest without
/// damping, K (1 + beta) x^beta and C x^gamma.
ClosedContacts closed_contacts(const Column<double>& column);

/// Of a lattice its motions with the largest spring, dashpot and friction (D_t), and of the last two together. In a
/// wave of the infinite lattice of equal beads these go as s K, s C and r D_t with s + r = 2 sum over its three bonds
/// of (1 - cos): (s, r) = (6, 2) is the stiffest, but with D_t > C (2, 6), with D_t about C (9/2, 9/2) is damped more.
/// Of finite lattices they are found by power iteration; from 40 rows or columns on 40 are taken. The damping of
/// motions in between is up to 3 % more.
///
/// It is a safe side in that a collision need not excite these motions: in a lattice without shifts all columns move
/// alike, discs of a row that have no gap but no overlap either are not in contact, and where gaps are wide few are at
/// a time.
ClosedContacts closed_contacts(const Lattice<double>& lattice);

/// Of the tuple's column or lattice. What vibrates is taken to be thrown at its plate with the largest speed of that.
/// Strong damping by laws that are not linear takes time, up to 0.1 s (see reduced_column()), a lattice up to 0.05 s.
ClosedContacts closed_contacts(const Parameters& parameters);

/// Everything that the stability of a tuple depends on, beside integrator and step: tuples with equal signatures have
/// the same closed contacts. Of equal beads that is neither v0 nor s0.
using StabilitySignature = std::vector<std::uint64_t>;
StabilitySignature stability_signature(const Parameters& parameters);

/// Whether closed_contacts() searches the motions of a lattice of unequal beads, which takes up to 0.05 s.
bool has_searched_motions(const Parameters& parameters);

/// Growth up to which it counts as stable: gear5 adds a little even where it is of use.
inline constexpr double max_stable_growth = 1.05;

/// What the scheme makes of the most unstable mode's amplitude in N tc, or rows tc, about the duration of a collision;
/// may be infinite. `dt` in the column's units.
double predicted_growth(const ClosedContacts& closed, Integrator integrator, double dt);
bool is_stable(const ClosedContacts& closed, Integrator integrator, double dt);
/// The same in one tc, whatever N is.
double growth_in_a_contact(const ClosedContacts& closed, Integrator integrator, double dt);

/// Of a tuple with a fixed-step integrator and its steps_per_tc > 0.
double predicted_growth(const Parameters& parameters);
bool is_stable(const Parameters& parameters);

}  // namespace sigmasweep
