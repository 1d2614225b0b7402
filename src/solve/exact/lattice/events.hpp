#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "assembly/ground.hpp"
#include "assembly/lattice.hpp"
#include "solve/exact/lattice/energies.hpp"
#include "solve/exact/lattice/regroup.hpp"
#include "solve/exact/lattice/schedule.hpp"
#include "solve/exact/lattice/state.hpp"
#include "solve/outcome.hpp"
#include "solve/stop_logic.hpp"

namespace sigmasweep {

/// The event loop of a lattice: from event to event in the order of time (schedule.hpp). Beads whose motion an event
/// changes are regrouped into clusters (regroup.hpp), and their next events predicted.
///
/// Ground: a fixed bottom, or a container that vibrates under gravity, seen from it.
template <class Real, class Ground = FixedWall>
class LatticeEvents {
 public:
  /// `accuracy`: local error of a step, in units of the speed and of speed times tc.
  LatticeEvents(const Lattice<Real>& lattice, double accuracy, const RunLimits& limits, const Ground& ground = {});

  /// To the end of the collision, or of the watcher's interest (lattice_samples.hpp).
  template <class Watcher>
  LatticeOutcome<Real> run(Watcher& watcher);
  /// On a plate, instead of run(): period by period, until the watcher (LatticeStatistics) has seen enough.
  template <class Watcher>
  LatticeOutcome<Real> follow(Watcher& watcher) requires(Ground::moves);

  LatticeEvents(const LatticeEvents&) = delete;  // its parts refer to each other
  LatticeEvents& operator=(const LatticeEvents&) = delete;

 private:
  using State = LatticeState<Real, Ground>;
  using Event = LatticeEvent<Real>;
  using Kind = LatticeEventKind;
  using Placed = typename Regrouping<Real, Ground>::Placed;

  void handle_next();
  void handle(const Event& event);
  void change_gap(const Event& event);
  bool locate(Real& t, std::size_t i, const Neighbour<Real>& other, std::span<const std::size_t> whole);
  void close_contact(std::size_t i, const Neighbour<Real>& other, const Real& t);
  void open_contact(std::size_t i, const Neighbour<Real>& other, const Real& t);
  void count_contact_time(const Real& t);
  void note_wait(const Real& t);
  void begin_anew(const Real& t);
  Real approach();
  Real held();
  void look_for_end(LatticeOutcome<Real>& outcome, const Real& t);
  void note_ending_uncertainty(LatticeOutcome<Real>& outcome);
  Status why_stop();
  void show_at(const Real& t, std::span<Vec2<double>> q, std::span<Vec2<double>> v) const;
  template <class Watcher>
  void show(Watcher& watcher, const Real& t);

  State state_;
  StopLogic stop_;
  Real closing_overlap_;
  EventSchedule<Real, Ground> schedule_;
  Regrouping<Real, Ground> regrouping_;
  LatticeEnergies<Real, Ground> energies_;
  Real now_{}, epoch_{};  ///< the clock began at epoch_
  Real last_touch_{}, last_change_{}, wall_closed_ = -Real(1), wall_opened_{};
  Real contact_time_{}, counted_to_{};
  Waits<Real> waits_;
  std::uint64_t closed_ = 0, contacts_ = 0, work_ = 0, all_work_ = 0;
};

}  // namespace sigmasweep
