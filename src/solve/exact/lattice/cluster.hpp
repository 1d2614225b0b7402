#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "assembly/ground.hpp"
#include "assembly/lattice.hpp"
#include "assembly/neighbours.hpp"
#include "base/vec2.hpp"
#include "contact/contact_forces.hpp"
#include "numerics/dormand_prince.hpp"

namespace sigmasweep {

/// A bead's motion in a step, by Hermite's quintics for the way from where the step began: velocities keep their digits
/// in steps that are next to nothing beside the displacement.
template <class Real>
struct BeadMotion {
  Vec2<Real> origin;
  Quintic<Real> x, z;
  Real begin, span;
  BeadMotion(const Vec2<Real>& origin_, const BeadState<Real>& from, const BeadState<Real>& to, const Real& begin_,
             const Real& span_)
      : origin(origin_),
        x({from.q.x, from.v.x, from.a.x}, {to.q.x, to.v.x, to.a.x}, span_),
        z({from.q.z, from.v.z, from.a.z}, {to.q.z, to.v.z, to.a.z}, span_),
        begin(begin_),
        span(span_) {}
  BeadState<Real> at(const Real& t) const {
    const Real s = (t - begin) / span;
    const Motion<Real> horizontal = x.at(s, span), vertical = z.at(s, span);
    return {origin + Vec2<Real>{horizontal.x, vertical.x}, {horizontal.u, vertical.u}, {horizontal.a, vertical.a}};
  }
};

/// Beads that are moved together by DOP853, Eqs. (2)-(4):
///     m_i q_i'' = sum_j F n + f_t,  F = K x^(1+beta) + C x^gamma x',  f_t = -D_t m_ij (v_ij.t) t,
/// x the overlap, n from partner j to bead i; a wall is a partner of infinite mass at rest. Beads of other clusters
/// that touch some of these are guests: their motions are given.
/// Ground: on a plate, seen from it, all beads fall with its load (Plate::load), and the works (PlateWork) are
/// integrated along with the motion.
template <class Real, class Ground = FixedWall>
class LatticeCluster {
 public:
  /// A contact that overlaps by less than `resting_overlap` and moves by less than `slowest` rests.
  LatticeCluster(const Lattice<Real>& lattice, const Real& accuracy, const Ground& ground, const Real& resting_overlap,
                 const Real& slowest);

  /// No beads, no guests, no contacts.
  void clear();
  /// A bead of the cluster, where it is now. Its place in beads() is its slot.
  void add(std::uint32_t bead, const Vec2<Real>& q, const Vec2<Real>& v);
  /// A guest, which gets a slot of its own. After all beads.
  std::uint32_t add_guest(std::uint32_t bead, const BeadMotion<Real>& motion);
  /// The bead in slot `first` touches the one in slot `second` (of a wall it has none to give).
  void add_contact(std::uint32_t first, std::uint32_t second, const Neighbour<Real>& with);

  const std::vector<std::uint32_t>& beads() const { return beads_; }

  /// A step from the present state at time `begin`, not longer than `longest`. False if no step is small enough.
  bool step(const Real& begin, const Real& longest);
  /// The step just made, but only up to t.
  void cut(const Real& t);

  const Real& begin() const { return begin_; }
  Real end() const { return begin_ + span_; }
  /// Of bead number `place` in the step: exact at its ends, else by Hermite's quintic.
  BeadState<Real> at(std::size_t place, const Real& t) const;
  BeadMotion<Real> motion(std::size_t place) const {
    return {origin_[place], way(start_, start_slope_, place), way(end_, end_slope_, place), begin_, span_};
  }
  /// The largest overlap of contacts in the step, if above `known`; else `known`. owns(place): whether it still has
  /// that bead.
  template <class Owns>
  Real deepest(Real known, Owns&& owns) const {
    for (const Contact& c : contacts_)
      if (owns(c.first) && (c.second >= wall() || owns(c.second)))
        known = largest_between(overlap(c, begin_), overlap(c, end()), span_, known);
    return known;
  }
  /// The largest speed at the end.
  Real fastest() const;
  /// From the step's begin to its end.
  PlateWork work() const requires(Ground::moves) { return {double(end_[works()]), double(end_[works() + 1])}; }

  /// How long the next step may be, from experience; and where this one is cut at t.
  Real after_cut(const Real& t) const;
  const Real& next_span() const { return next_; }
  void expect(const Real& span) { next_ = span; }
  std::uint64_t work_done() const { return work_; }  ///< beads and contacts times evaluations so far

 private:
  struct Contact {
    std::uint32_t first, second;
    Neighbour<Real> with;
  };
  /// How far the beads have gone since the step began, x and z, then their velocities; on a plate the two works.
  using State = std::vector<Real>;

  std::size_t wall() const { return beads_.size(); }  ///< its slot; those of guests come after it
  std::size_t works() const { return 4 * beads_.size(); }
  Vec2<Real> vector(const State& y, std::size_t part, std::size_t place) const {
    const std::size_t at = 2 * (part * beads_.size() + place);
    return {y[at], y[at + 1]};
  }
  BeadState<Real> way(const State& y, const State& dy, std::size_t place) const {
    return {vector(y, 0, place), vector(y, 1, place), vector(dy, 1, place)};
  }
  BeadState<Real> state(const State& y, const State& dy, std::size_t place) const {
    BeadState<Real> state = way(y, dy, place);
    state.q += origin_[place];
    return state;
  }
  BeadState<Real> slot_state(std::size_t slot, const Real& t) const;
  void slopes(const State& y, State& dy, const Real& at);
  void place_slots(const State& y, const Real& at);
  void start_slopes();
  void add_linear_forces();
  void add_forces();
  void works_of_plate(State& dy, const Real& at) requires(Ground::moves);
  Real trial(const Real& span);
  Motion<Real> overlap(const Contact& contact, const Real& t) const;

  const Lattice<Real>& lattice_;
  Real accuracy_, resting_overlap_, slowest_;
  [[no_unique_address]] Ground ground_;
  ContactForces<Real> force_;
  bool linear_;
  std::vector<std::uint32_t> beads_;
  std::vector<BeadMotion<Real>> guests_;
  std::vector<Contact> contacts_;
  std::vector<Real> mass_, inverse_mass_;      ///< of the slots (of the wall 0); of the beads
  std::vector<Real> K_, C_, C_t_, x_, u_, F_;  ///< of the contacts
  std::vector<Vec2<Real>> n_, w_;
  std::vector<std::uint8_t> rests_;    ///< which contacts rest
  std::vector<Vec2<Real>> origin_;     ///< displacements of the beads where the step begins
  std::vector<Vec2<Real>> q_, v_, f_;  ///< of the slots
  State start_, end_, start_slope_, end_slope_;
  Real begin_{}, span_{}, next_{};
  std::uint64_t work_ = 0;
  DormandPrince<Real> scheme_;
};

}  // namespace sigmasweep
