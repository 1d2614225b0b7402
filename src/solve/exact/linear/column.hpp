#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "assembly/column.hpp"
#include "assembly/energy_balance.hpp"
#include "numerics/noise.hpp"
#include "solve/exact/event_loop_on_ground.hpp"
#include "solve/exact/linear/collision.hpp"
#include "solve/exact/linear/pair_table.hpp"
#include "solve/exact/linear/resting/resting_beads.hpp"
#include "solve/exact/linear/step_lengths.hpp"
#include "solve/exact/linear/taylor_group.hpp"
#include "solve/observer/samples.hpp"
#include "solve/stop_logic.hpp"

namespace sigmasweep {

/// Contacts lo..hi that a linear column moves together: every closed one, its open neighbours, and whatever shares one
/// of these.
template <class Real, class Taylor>
struct ExactGroup {
  std::size_t lo = 0, hi = 0;
  Real start{}, length{};   ///< the present step, in time
  std::size_t contact = 0;  ///< which contact changes at the step's end, if `event`
  bool event = false, binary = false;
  bool resting = false;   ///< plate: the step goes by RestingCluster
  bool prepared = false;  ///< Taylor: the laws are set
  Real longest{};         ///< Taylor: how far the series reaches, in time
  Real scaled{};          ///< Taylor: length over longest
  Taylor taylor;
};

/// What a column above a fixed wall has instead of RestingBeads.
struct NothingRests {};

/// A column under the linear law that moves from contact event to contact event (event_loop.hpp). A group of contacts
/// is propagated by Taylor series, exact to rounding; a lone contact that nothing can disturb in one closed formula.
///
/// Tangents: number of linearised disturbances beside the column's own motion. Their source is the rounding of the
/// state, drawn at random step by step; the same linear maps, and the jumps at the events, carry them along. They
/// measure how much of the rounding error survives to the end. See docs/physics/error-bars.md.
///
/// HasUnequalMasses: the beads have masses of their own (column.mass). Gaps that differ need no such feature.
///
/// Order: of the Taylor series. Where it is low the terms that they leave out take the place of rounding.
///
/// Ground: a fixed wall, or a plate that vibrates under gravity.
template <class Real, int Tangents, bool HasUnequalMasses, int Order = TaylorOrder<Real>::value,
          class Ground = FixedWall>
class ExactColumn
    : private GroundEvents<ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>, Real,
                           ExactGroup<Real, TaylorGroup<Real, Tangents, HasUnequalMasses, Order, Ground::moves>>,
                           Tangents, Ground> {
 public:
  ExactColumn(const Column<Real>& column, const RunLimits& limits, const Ground& ground = {});
  /// Before run(): all contacts open, gaps as in the column (the wall's, too), and these closing speeds. Time 0 is now.
  void start_from(std::span<const Real> rates);
  Outcome<Real> run();
  /// The same, seen by a watcher (samples.hpp), and over with its last sample. Samples: double without disturbances.
  template <class Watcher>
  Outcome<Real> run(Watcher& watcher);
  /// On a plate, instead of run(): event_loop_on_ground.hpp.
  template <class Watcher>
  Outcome<Real> follow(Watcher& watcher) requires(Ground::moves) {
    return Events::follow(watcher);
  }
  /// After run(): a bound of the error of eps_eff, `safety` times the disturbances' size.
  Real error(double safety) const;
  /// After run(): a bound of the error of the velocities, a mass-weighted root mean square over the initial speed.
  Real velocity_error(double safety) const;
  /// After run(): the largest change of eps_eff by a disturbance.
  Real disturbance() const { return balance().disturbance; }
  /// What a step adds to the error, relative to the state.
  static Real local_error() { return std::max(std::numeric_limits<Real>::epsilon(), Taylor::left_out()); }
  /// Contacts propagated, summed over all Taylor steps: what a run in a wider type would cost.
  std::uint64_t work() const { return work_; }

 private:
  static constexpr double longest_clock = 16.0;  ///< t_c
  static constexpr int motions = 1 + Tangents;
  using State = ContactState<Real>;
  using Taylor = TaylorGroup<Real, Tangents, HasUnequalMasses, Order, Ground::moves>;
  using Group = ExactGroup<Real, Taylor>;
  using Events = GroundEvents<ExactColumn, Real, Group, Tangents, Ground>;
  friend Events;
  friend ContactEvents<ExactColumn, Real, Group, Tangents>;
  using Events::N_, Events::motion_, Events::x_, Events::u_, Events::at_, Events::closed_, Events::group_of_,
      Events::epoch_, Events::events_, Events::contacts_, Events::wall_opened_, Events::x_max_, Events::ground_,
      Events::state, Events::velocities;
  using typename Events::Motion;

  /// Where eps_eff stands at a moment within the collision.
  struct Balance {
    Real disturbance{};  ///< largest change of sqrt(E/E_0), E kinetic plus elastic, by a disturbance
    Real remaining{};    ///< at most this can sqrt(E/E_0) still fall
    Real distance{};     ///< largest disturbance, as a velocity over the initial speed
    Real ahead{};        ///< how far apart final velocities may be that follow from this moment
    Real present{};      ///< how far the present velocities may be from final ones
  };

  void disturb_gaps();
  static std::unique_ptr<Group> new_group() { return std::make_unique<Group>(); }
  static void start_group(Group& group) { group.prepared = false; }
  void step_group(Group& group);
  static const Real& length_of(const Group& group) { return group.length; }
  static std::optional<std::size_t> event_of(const Group& group) {
    return group.event ? std::optional(group.contact) : std::nullopt;
  }
  Real closes_in(std::size_t k) const { return this->closes_at(k, Real(0)); }
  void advance_free(std::size_t k, const Real& t);
  void change_contact(std::size_t k, const Real& t);
  void move_group(Group& group, const Real& elapsed, bool whole_step);
  void move_taylor(Group& group, const Real& elapsed, bool whole_step);
  void move_binary(Group& group, const Real& elapsed, bool whole_step);
  void disturb(std::size_t i, const State& magnitude);
  bool begin_binary(Group& group);
  void begin_taylor(Group& group);
  void drive(Group& group, Real& h) requires(Ground::moves);
  bool begin_rest(Group& group) requires(Ground::moves);
  PlateWork work_of(const Group& group, const Real& elapsed) const requires(Ground::moves);
  Status why_stop() { return stop_.why_stop(contacts_, work_, 1 + closed_count_); }
  Balance balance() const;
  bool settled(std::uint64_t step);
  void state_at(const Real& t, std::span<Real> x, std::span<Real> u) const;

  Column<Real> column_;
  StopLogic stop_;
  SettleSchedule settle_schedule_;
  [[no_unique_address]] std::conditional_t<Ground::moves, RestingBeads, NothingRests> resting_;
  ContactLaws<Real, HasUnequalMasses> laws_;
  StepLengths<Real, HasUnequalMasses> steps_;
  Noise noise_;
  std::size_t closed_count_ = 0;
  std::uint64_t work_ = 0;
  std::vector<Balance> balances_;  ///< those that could give the smallest error
};

}  // namespace sigmasweep
