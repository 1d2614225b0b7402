#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "contact/contact_state.hpp"
#include "numerics/tournament.hpp"

namespace sigmasweep {

/// A column that moves from contact event to contact event: who is where, and who is next. Contacts are numbered 0 (the
/// wall) to N-1. The state is the overlaps x and their rates u = x', not positions: an overlap of 1e-12 keeps all its
/// digits whatever the column's length. Beads without a closed contact fly freely: their gaps are brought up to date
/// only when somebody asks. Each group of closed contacts, with the open gaps beside them, runs on its own clock from
/// step to step; whichever group or gap has the earliest event is next. The time of an event is found by the group that
/// makes the step: for the linear law see linear/taylor_group.hpp and numerics/first_root.hpp. Motions: the column's
/// own, and linearised disturbances that are carried along.
///
/// The Solver, which derives from this class, moves the groups. It must have (check_contract() refuses others):
///     std::unique_ptr<Group> new_group()              an empty one, with members lo, hi and start
///     void start_group(Group&)                        contacts lo..hi are its own from now on
///     void step_group(Group&)                         its next step
///     Real length_of(const Group&)                    of that step, in time
///     std::optional<size_t> event_of(const Group&)    which contact closes or opens at the step's end
///     void move_group(Group&, elapsed, whole_step)    x and u to `elapsed` after the step's start
///     void advance_free(k, t)                                  free gap k from time at_[k] to t
///     void change_contact(k, t)                       it closes or opens; its neighbours are at time t, too
///     Real closes_in(k)                               how long free gap k stays open
template <class Solver, class Real, class Group, int Tangents = 0>
class ContactEvents {
 protected:
  static constexpr int none = -1;
  /// Overlaps and rates of all contacts.
  struct Motion {
    std::vector<Real> x, u;
  };
  struct Range {
    std::size_t lo, hi;
  };

  explicit ContactEvents(std::size_t contacts)
      : N_(contacts),
        x_(motion_[0].x),
        u_(motion_[0].u),
        at_(N_, Real(0)),
        closed_(N_, 0),
        group_of_(N_, none),
        events_(N_) {
    check_contract();
    for (Motion& motion : motion_) {
      motion.x.assign(N_, Real(0));
      motion.u.assign(N_, Real(0));
    }
  }
  ~ContactEvents() = default;

  ContactState<Real> state(std::size_t k) const { return {x_[k], u_[k]}; }

  /// The next event, which is at time t.
  void advance(const Real& t) {
    const std::size_t next = events_.first();
    if (group_of_[next] != none)
      finish_step(group_of_[next]);
    else
      close_gap(next, t);
  }

  bool nothing_touches() const { return idle_.size() == groups_.size(); }

  /// At a fixed wall, where nothing touches, time t may become time 0: flights may be so long that a clock which counts
  /// them all could not tell the moments of a contact apart.
  void begin_anew(const Real& t) {
    for (std::size_t k = 0; k < N_; ++k) {
      release(k, t);
      at_[k] = Real(0);
      schedule_gap(k);
    }
    epoch_ += t;
  }

  /// Brings contact k up to time t and out of its group, if it is in one. Returns what has been released with it.
  Range release(std::size_t k, const Real& t) {
    if (const int id = group_of_[k]; id != none) {
      const Range range{group(id).lo, group(id).hi};
      dissolve(id, t);
      return range;
    }
    if (at_[k] != t) solver().advance_free(k, t);
    at_[k] = t;
    return {k, k};
  }

  /// Sorts the contacts of `range`, all of them free of groups and at time t, into groups and free gaps, taking in
  /// neighbours that a closed contact at the border touches.
  void regroup(Range range, const Real& t) {
    while (closed_[range.lo] && range.lo > 0) range.lo = release(range.lo - 1, t).lo;
    while (closed_[range.hi] && range.hi + 1 < N_) range.hi = release(range.hi + 1, t).hi;
    for (std::size_t k = range.lo; k <= range.hi; ++k) {
      if (!closed_[k] && !(k < range.hi && closed_[k + 1])) {
        schedule_gap(k);
        continue;
      }
      std::size_t end = k;  // the group's last contact: an open one with no closed one after it, or the border
      while (end < range.hi && (closed_[end] || closed_[end + 1])) ++end;
      make_group({k, end}, t);
      k = end;
    }
  }

  void schedule_gap(std::size_t k) { events_.set(k, at_[k] + solver().closes_in(k)); }

  /// Of a gap that flies uniformly and closes at `overlap`.
  Real closes_uniformly(std::size_t k, const Real& overlap) const {
    if (!(u_[k] > 0)) return std::numeric_limits<Real>::infinity();
    return std::max(Real(overlap - x_[k]), Real(0)) / u_[k];
  }

  /// v_i from the rates: u_0 = -v_1 at the wall, u_k = v_k - v_(k+1) between beads.
  std::vector<Real> velocities(std::size_t motion = 0) const {
    std::vector<Real> v(N_);
    Real sum = 0;
    for (std::size_t k = 0; k < N_; ++k) v[k] = sum -= motion_[motion].u[k];
    return v;
  }

  Group& group(int id) { return *groups_[std::size_t(id)]; }
  const Group& group(int id) const { return *groups_[std::size_t(id)]; }

  std::size_t N_;
  std::array<Motion, std::size_t(1 + Tangents)> motion_;  ///< the column's own, then its tangents
  std::vector<Real>&x_, &u_;                              ///< of the column's own motion
  Real epoch_{};                                          ///< when the clock was last set to 0, since the start
  std::vector<Real> at_;                                  ///< free gaps: the time their state is of
  std::vector<std::uint8_t> closed_;
  std::vector<int> group_of_;
  std::vector<std::unique_ptr<Group>> groups_;
  std::vector<int> idle_;  ///< groups free for use
  Tournament<Real> events_;
  std::uint64_t contacts_ = 0;  ///< closed and opened again
  Real wall_opened_{}, x_max_{};

 private:
  /// Refuses a Solver that lacks a function, with the function's name. Here, as these are private to Solver.
  static void check_contract() {
    static_assert(
        requires(Solver & s) {
          { s.new_group() } -> std::same_as<std::unique_ptr<Group>>;
        },
        "new_group()");
    static_assert(
        requires(Solver & s, Group & g) {
          s.start_group(g);
          s.step_group(g);
        },
        "start_group(), step_group()");
    static_assert(
        requires(Solver & s, const Group& g) {
          { s.length_of(g) } -> std::convertible_to<Real>;
        },
        "length_of()");
    static_assert(
        requires(Solver & s, const Group& g) {
          { s.event_of(g) } -> std::same_as<std::optional<std::size_t>>;
        },
        "event_of()");
    static_assert(
        requires(Solver & s, Group & g, const Real& t) { s.move_group(g, t, true); }, "move_group()");
    static_assert(
        requires(Solver & s, std::size_t k, const Real& t) {
          s.advance_free(k, t);
          s.change_contact(k, t);
        },
        "advance_free(), change_contact()");
    static_assert(
        requires(Solver & s, std::size_t k) {
          { s.closes_in(k) } -> std::convertible_to<Real>;
        },
        "closes_in()");
    static_assert(
        requires(Group & g, const Real& t) {
          g.lo = g.hi;
          g.start = t;
        },
        "Group: lo, hi, start");
  }

  Solver& solver() { return static_cast<Solver&>(*this); }

  void close_gap(std::size_t k, const Real& t) {
    Range range = release(k, t);
    if (k > 0) range.lo = release(k - 1, t).lo;
    if (k + 1 < N_) range.hi = release(k + 1, t).hi;
    solver().change_contact(k, t);
    regroup(range, t);
  }

  void finish_step(int id) {
    Group& g = group(id);
    const Real length = solver().length_of(g), t = g.start + length;
    const auto event = solver().event_of(g);
    solver().move_group(g, length, true);
    g.start = t;
    if (!event) {
      begin_step(g);
      return;
    }
    Range range{g.lo, g.hi};
    dissolve(id, t);
    // A gap at the group's border closes with a neighbour that is not of the group.
    if (*event == range.lo && range.lo > 0) range.lo = release(range.lo - 1, t).lo;
    if (*event == range.hi && range.hi + 1 < N_) range.hi = release(range.hi + 1, t).hi;
    solver().change_contact(*event, t);
    regroup(range, t);
  }

  /// Ends a group; if its step is not over yet, at a time t within it.
  void dissolve(int id, const Real& t) {
    Group& g = group(id);
    if (g.start != t)
      solver().move_group(g, std::min(std::max(Real(t - g.start), Real(0)), Real(solver().length_of(g))), false);
    for (std::size_t k = g.lo; k <= g.hi; ++k) {
      group_of_[k] = none;
      at_[k] = t;
    }
    events_.remove(g.lo);
    idle_.push_back(id);
  }

  void make_group(Range range, const Real& t) {
    if (idle_.empty()) {
      idle_.push_back(int(groups_.size()));
      groups_.push_back(solver().new_group());
    }
    const int id = idle_.back();
    idle_.pop_back();
    Group& g = group(id);
    g.lo = range.lo;
    g.hi = range.hi;
    g.start = t;
    for (std::size_t k = range.lo; k <= range.hi; ++k) {
      group_of_[k] = id;
      if (k != range.lo) events_.remove(k);
    }
    solver().start_group(g);
    begin_step(g);
  }

  void begin_step(Group& g) {
    solver().step_group(g);
    events_.set(g.lo, g.start + solver().length_of(g));
  }
};

}  // namespace sigmasweep
