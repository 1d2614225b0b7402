#pragma once

#include <algorithm>
#include <cstdint>

#include "solve/fixed_step/driver.hpp"

namespace sigmasweep {

/// The Course of a collision with a wall: it is over when no later contact matters. Free flight is skipped.
/// Ending: when that is, of a column (column/ending.hpp) or a lattice (lattice/ending.hpp).
template <class Ending>
class CollisionCourse {
 public:
  static constexpr bool skips_free_flight = true;
  static constexpr std::uint64_t steps_between_checks = 16, steps_between_outlooks = Ending::steps_between_outlooks;

  explicit CollisionCourse(Ending ending) : ending_(ending) {}

  template <class System>
  static std::uint64_t event_limit(const System& system) {
    return Ending::event_limit(system.beads());
  }
  template <class System>
  static constexpr std::uint64_t work_limit() {
    return Ending::max_work;
  }
  /// Where time t lies within the last `steps`, 0 to 1. In steps.
  static double fraction(double t, double now, double steps) { return 1.0 - (now - t) / steps; }

  template <class System, class Observer>
  Verdict begin(const System& system, const Observer& /*observer*/) {
    lowest_energy_ = start_energy_ = system.energy();
    return {};
  }
  template <class System>
  void set_time(const System& /*system*/, double /*now*/) const {}
  double clock(double now) const { return now; }

  /// A contact with the ground closes or opens.
  void touch(double when, bool closes) {
    if (closes && first_touch_ < 0.0) first_touch_ = when;
    last_touch_ = when;
  }
  /// From the first to the last contact with the ground, in steps.
  double touch_time() const { return last_touch_ - std::max(first_touch_, 0.0); }

  template <class System>
  void note(const System& /*system*/, double now, bool any_closed) {
    ending_.note(now, any_closed);
  }
  template <class System, class Observer>
  Verdict after_step(const System& /*system*/, const Observer& /*observer*/, double now, bool /*is_on*/) const {
    return ending_.quiet(now);
  }

  /// Energy can only fall. If it rises again by 5 % of the initial energy, or beyond all numbers, the scheme is
  /// unstable.
  template <class System>
  Verdict check(const System& system, bool is_on) {
    const double E = system.energy();
    Verdict verdict;
    if (!(E <= lowest_energy_ + 0.05 * start_energy_)) verdict.status = Status::unstable;
    lowest_energy_ = std::min(lowest_energy_, E);
    if (verdict.status == Status::ok && is_on) verdict = ending_.by_energy(E, start_energy_);
    return verdict;
  }
  template <class System>
  Verdict look_ahead(System& system, double now) {
    return ending_.look_ahead(system, now, start_energy_);
  }
  template <class System>
  FreeFlightAhead free_flight(System& system, double now) const {
    return ending_.free_flight(system, now, start_energy_);
  }

 private:
  Ending ending_;
  double first_touch_ = -1.0, last_touch_ = 0.0;
  double start_energy_ = 0.0, lowest_energy_ = 0.0;
};

}  // namespace sigmasweep
