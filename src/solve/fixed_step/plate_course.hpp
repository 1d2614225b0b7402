#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "assembly/ground.hpp"
#include "solve/fixed_step/driver.hpp"

namespace sigmasweep {

/// The Course on a vibrated plate: it is over when the observer has seen all periods, each of the same whole number of
/// steps. Works are sums over the steps by the trapezoidal rule, so energies balance as well as the steps are short.
class PlateCourse {
 public:
  static constexpr bool skips_free_flight = false;
  static constexpr std::uint64_t steps_between_checks = 1, steps_between_outlooks = 1;

  PlateCourse(const Plate& plate, double steps_per_period) : plate_(plate), period_(steps_per_period) {}

  template <class System>
  static std::uint64_t event_limit(const System& /*system*/) {
    return std::numeric_limits<std::uint64_t>::max();
  }
  template <class System>
  static constexpr std::uint64_t work_limit() {
    return std::numeric_limits<std::uint64_t>::max();
  }
  /// Where time t lies within the last step, 0 to 1. In steps since the period began.
  static double fraction(double t, double now, double /*steps*/) { return t - (now - 1.0); }

  template <class System, class Observer>
  Verdict begin(const System& system, const Observer& observer) {
    start_energy_ = system.energy_on(plate_);
    weight_ = system.weight(plate_);
    lost_before_ = system.power_lost();
    in_before_ = system.power_in(plate_, 0.0);
    return periods_over(observer);
  }
  template <class System>
  void set_time(System& system, double now) const {
    system.set_time(now);
  }
  double clock(double now) const { return now < period_ ? now : 0.0; }

  void touch(double /*when*/, bool /*closes*/) {}
  double touch_time() const { return 0.0; }

  template <class System>
  void note(const System& system, double now, bool /*any_closed*/) {
    const double lost = system.power_lost(), in = system.power_in(plate_, now);
    lost_ += 0.5 * (lost_before_ + lost);
    in_ += 0.5 * (in_before_ + in);
    lost_before_ = lost;
    in_before_ = in;
  }

  /// At the end of a period tells the observer of its energies. Energy that neither the plate brought nor the contacts
  /// left shows that the scheme is unstable. The limit is half of the weight of the beads times the path of the plate;
  /// stable steps stay far below, and an infinite energy is above.
  template <class System, class Observer>
  Verdict after_step(const System& system, Observer& observer, double now, bool is_on) {
    if (now < period_) return {};
    const double gain = system.energy_on(plate_) - start_energy_;
    const double in = in_ / system.work_unit(), lost = lost_ / system.work_unit();
    path_ += 4.0 * plate_.A0;
    if (!(gain - in + lost <= 0.5 * std::max(std::fabs(in), weight_ * path_))) return {.status = Status::unstable};
    if (is_on) observer.end_period(gain, in, lost);
    return periods_over(observer);
  }
  template <class System>
  Verdict check(const System& /*system*/, bool /*is_on*/) const {
    return {};
  }
  template <class System>
  Verdict look_ahead(const System& /*system*/, double /*now*/) const {
    return {};
  }
  template <class System>
  FreeFlightAhead free_flight(const System& /*system*/, double /*now*/) const {
    return {};
  }

 private:
  template <class Observer>
  static Verdict periods_over(const Observer& observer) {
    return {.end = observer.done() ? End::periods : End::none};
  }

  Plate plate_;
  double period_;
  double start_energy_ = 0.0, weight_ = 0.0, path_ = 0.0;
  double lost_ = 0.0, in_ = 0.0, lost_before_ = 0.0, in_before_ = 0.0;
};

}  // namespace sigmasweep
