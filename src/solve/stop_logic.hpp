#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "sigmasweep/model/result.hpp"
#include "solve/run_limits.hpp"

namespace sigmasweep {

/// Decides when a run gives up: after too many contacts, too much work, or with no time left. Event loops ask it before
/// each event, fixed steps after each step.
class StopLogic {
 public:
  /// A solver's own limits stand in for those that are 0.
  StopLogic(const RunLimits& limits, std::uint64_t own_event_limit, std::uint64_t own_work_limit) : limits_(limits) {
    if (limits_.event_limit == 0) limits_.event_limit = own_event_limit;
    if (limits_.work_limit == 0) limits_.work_limit = own_work_limit;
  }

  /// Status::ok: go on. `cost`: work since the last question, for the budget's clock.
  Status why_stop(std::uint64_t contacts, std::uint64_t work, std::uint64_t cost) const {
    return limits_reached(contacts, work) ? Status::event_limit : time_is_over(cost) ? Status::time_limit : Status::ok;
  }
  /// The two halves of why_stop(), for loops that seldom look at the clock.
  bool limits_reached(std::uint64_t contacts, std::uint64_t work) const {
    return contacts >= limits_.event_limit || work >= limits_.work_limit;
  }
  bool time_is_over(std::uint64_t cost) const { return limits_.budget && limits_.budget->is_over(cost); }

  std::uint64_t event_limit() const { return limits_.event_limit; }
  double settle() const { return limits_.settle; }

 private:
  RunLimits limits_;
};

/// Says when an event loop of N contacts should look whether its column has settled, as a look costs about N: after
/// some contacts, or after many steps in which overdamped contacts creep.
class SettleSchedule {
 public:
  /// The first look is at once.
  SettleSchedule(std::size_t N, std::uint64_t steps_between)
      : contacts_between_(contacts_between(N)), steps_between_(steps_between) {}

  static std::uint64_t contacts_between(std::size_t N) { return std::max<std::size_t>(5, N / 8); }

  bool is_due(std::uint64_t contacts, std::uint64_t steps) {
    if (contacts < next_contacts_ && steps < next_steps_) return false;
    note_look(contacts, steps);
    return true;
  }
  /// A look at this moment counts as done.
  void note_look(std::uint64_t contacts, std::uint64_t steps) {
    next_contacts_ = contacts + contacts_between_;
    next_steps_ = steps + steps_between_;
  }

 private:
  std::uint64_t contacts_between_, steps_between_, next_contacts_ = 0, next_steps_ = 0;
};

}  // namespace sigmasweep
