#pragma once

#include <cstddef>
#include <cstdint>

#include "solve/exact/lattice/event_queue.hpp"
#include "solve/exact/lattice/state.hpp"

namespace sigmasweep {

/// Predicts the events of a lattice from the motions of its beads as far as they are known, and keeps them in the order
/// of time. When a bead's motion changes its predictions are void (its version grows), and are made anew.
template <class Real, class Ground>
class EventSchedule {
 public:
  using State = LatticeState<Real, Ground>;

  /// A gap counts as closed at an overlap of `closing_overlap`; `slowest`: see `shallow` in schedule.cpp.
  EventSchedule(const State& state, const Real& closing_overlap, const Real& slowest)
      : state_(state), closing_overlap_(closing_overlap), slowest_(slowest) {}

  /// Time of the next valid event; infinity where there is none.
  Real next_time();
  bool is_empty() const { return queue_.empty(); }
  LatticeEventKind next_kind() const { return queue_.top().kind; }
  /// The next event, after next_time(), which leaves the schedule.
  LatticeEvent<Real> take_next();
  void clear() { queue_ = {}; }

  /// The gap at which a contact that opens at that rate counts as open. Beads that rest beside each other move apart
  /// and together for ever, if ever so little: on a plate, slow contacts have their end at a small gap.
  Real open_from(const Real& rate) const { return Ground::moves && rate < slowest_ ? resting_overlap() : Real(0); }
  Real resting_overlap() const { return Real(8.0) * closing_overlap_; }
  const Real& slowest() const { return slowest_; }

  /// All events of bead i after t. Those with marked beads of smaller numbers are predicted from there.
  void predict_events(std::size_t i, const Real& t);
  /// The next event of bead i with one of its neighbours.
  void predict_events(std::size_t i, const Neighbour<Real>& other, const Real& t);
  /// The time when free bead i has gone so far that its list of neighbours must be made anew.
  void predict_list(std::size_t i, const Real& t) {
    enqueue(leaves(i, t), LatticeEventKind::list, static_cast<std::uint32_t>(i), {});
  }
  /// The end of a step of cluster `id`.
  void add_step(const Real& end, std::size_t id, std::uint32_t version) {
    queue_.push({end, LatticeEventKind::step, 0, std::uint32_t(id), 0, version, 0});
  }

 private:
  bool is_valid(const LatticeEvent<Real>& event) const;
  void enqueue(const Real& t, LatticeEventKind kind, std::uint32_t bead, const Neighbour<Real>& other);
  Real meeting_in_flight(std::size_t i, const Neighbour<Real>& other, const Real& t) const;
  bool is_far(std::size_t i, const Neighbour<Real>& other, const Real& t, const Real& end) const;
  Real meeting_of_motions(std::size_t i, const Neighbour<Real>& other, const Real& t, const Real& end) const;
  Real opening(std::size_t i, const Neighbour<Real>& other, const Real& t, const Real& end) const;
  Real leaves(std::size_t i, const Real& t) const;

  const State& state_;
  Real closing_overlap_, slowest_;
  EventQueue<Real> queue_;
};

}  // namespace sigmasweep
