#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "assembly/column.hpp"
#include "assembly/energy_balance.hpp"
#include "solve/exact/event_loop_on_ground.hpp"
#include "solve/exact/power_law/collision.hpp"
#include "solve/exact/power_law/group.hpp"
#include "solve/exact/power_law/isolated.hpp"
#include "solve/observer/samples.hpp"
#include "solve/stop_logic.hpp"

namespace sigmasweep {

/// Contacts lo..hi that a column moves together from `start`.
template <class Real, class Ground>
struct NonlinearGroup {
  NonlinearGroup(const Column<Real>& column, const Real& accuracy, const Ground& ground)
      : contacts(column, accuracy, ground) {}
  std::size_t lo = 0, hi = 0;
  Real start{};
  PowerLawGroup<Real, Ground> contacts;
};

/// One collision under a law that is not linear, from contact event to contact event (event_loop.hpp), in reduced
/// units. Ground: a fixed wall, or a plate that vibrates under gravity.
template <class Real, class Ground = FixedWall>
class NonlinearColumn
    : private GroundEvents<NonlinearColumn<Real, Ground>, Real, NonlinearGroup<Real, Ground>, 0, Ground> {
 public:
  /// `restitution_off`: see IsolatedContacts.
  NonlinearColumn(const Column<Real>& column, double accuracy, const RunLimits& limits, const Ground& ground = {},
                  double restitution_off = 0.0);
  Outcome<Real> run();
  /// The same, seen by a watcher (samples.hpp), and over with its last sample. Samples: double.
  template <class Watcher>
  Outcome<Real> run(Watcher& watcher);
  /// On a plate, instead of run(): event_loop_on_ground.hpp.
  template <class Watcher>
  Outcome<Real> follow(Watcher& watcher) requires(Ground::moves) {
    return Events::follow(watcher);
  }

 private:
  static constexpr double longest_clock = 16.0;  ///< t_c
  using Group = NonlinearGroup<Real, Ground>;
  using Events = GroundEvents<NonlinearColumn, Real, Group, 0, Ground>;
  friend Events;
  friend ContactEvents<NonlinearColumn, Real, Group>;
  using Events::N_, Events::x_, Events::u_, Events::at_, Events::closed_, Events::group_of_, Events::epoch_,
      Events::events_, Events::contacts_, Events::wall_opened_, Events::x_max_, Events::ground_, Events::velocities;

  std::unique_ptr<Group> new_group() { return std::make_unique<Group>(column_, Real(accuracy_), ground_); }
  void start_group(Group& group) { group.contacts.start(group.lo, group.hi, closed_, x_, u_); }
  void step_group(Group& group);
  static const Real& length_of(const Group& group) { return group.contacts.length(); }
  static std::optional<std::size_t> event_of(const Group& group) { return group.contacts.event(); }
  Real closes_in(std::size_t k) const {
    return is_busy(k) ? Real(std::max(x_[k], Real(0)) / -u_[k]) : Real(this->closes_at(k, closing_overlap_));
  }
  void advance_free(std::size_t k, const Real& t);
  PlateWork work_of(Group& group, const Real& elapsed) requires(Ground::moves);
  Status why_stop();
  void change_contact(std::size_t k, const Real& t);
  void move_group(Group& group, const Real& elapsed, bool whole_step);
  bool is_settled();

  // Isolated contacts. In the event loop they are gaps that fly freely.
  static constexpr bool can_isolate = std::is_same_v<Real, double> && !Ground::moves;
  bool is_busy(std::size_t k) const { return isolated_ && isolated_->is_busy(k); }
  bool handle_isolated(const Real& t);
  bool begin_isolated(std::size_t k, const Real& t);
  bool stay_open(std::size_t k, std::size_t beside, const Real& t, const ContactState<Real>& becomes) const;
  void end_isolated(std::size_t k, const Real& t);
  bool interrupt_near(std::size_t k, const Real& t);
  void replace_state(std::size_t k, const ContactState<Real>& state);
  void state_at(const Real& t, std::span<Real> x, std::span<Real> u);

  const Column<Real> column_;
  double accuracy_;
  StopLogic stop_;
  SettleSchedule settle_schedule_;
  Real closing_overlap_;
  std::optional<IsolatedContacts> isolated_;
  std::uint64_t steps_ = 0, work_ = 0;
  bool step_underflow_ = false;  ///< no step length was short enough
};

}  // namespace sigmasweep
