#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "sigmasweep/model/result.hpp"
#include "solve/fixed_step/step_options.hpp"
#include "solve/stop_logic.hpp"

/// The loop over fixed steps, one for columns and lattices, for walls and vibrated plates. It has three parts.
///
/// A System is a column or a lattice that a scheme steps (column/system.hpp, lattice/system.hpp):
///     scheme(), set_time(t)     its SchemeStepper; the start of the next step, in steps (on a plate)
///     look(touch)               which contacts have opened and closed; touch(before, now) is told of overlaps with the
///                               ground that change their sign
///     after_step(), after_coast()   bookkeeping of positions
///     remember()                keeps the state for between()
///     between(s, steps, ...)    state within the steps since remember(), s from 0 to 1 on the way
///     extrapolate(steps, ...)   state in free flight, so many steps from now
///     energy()                  kinetic and elastic, in the units of a step
///     fill(outcome)             final velocities and the largest overlap
/// on a plate also power_lost(), power_in(plate, t), work_unit(), weight(plate) and energy_on(plate).
///
/// A Course says when a run is over and whether its energy is right (collision_course.hpp, plate_course.hpp).
/// An Observer is shown the states (observer/).
namespace sigmasweep {

/// Which contacts changed in a step.
struct ContactChanges {
  std::uint64_t opened = 0;
  bool any_closed = false;
};

/// What a Course finds: whether the run goes on.
struct Verdict {
  Status status = Status::ok;
  End end = End::none;
  double remainder = 0.0;  ///< End::settled: what later contacts can still change eps_eff by
};

/// Free flight from now on: the number of steps in which no contact closes, unless the run is over.
struct FreeFlightAhead {
  double steps = 0.0;
  Verdict verdict;
};

template <class System, class Course, class Observer>
class FixedStepDriver {
 public:
  using Outcome = typename System::Outcome;

  FixedStepDriver(System& system, Course& course, const RunLimits& limits, const StepOptions& options,
                  Observer& observer)
      : system_(system),
        course_(course),
        stop_(limits, Course::event_limit(system), Course::template work_limit<System>()),
        options_(options),
        observer_(observer) {}

  Outcome operator()() {
    apply(course_.begin(system_, observer_));
    while (is_on()) {
      if (Course::skips_free_flight && !any_closed_ && system_.scheme().coasts()) cross_free_flight();
      if (!is_on()) break;
      advance();
      after_step();
      if constexpr (Course::skips_free_flight && Observer::observes)
        if (observer_.done()) break;
    }
    if constexpr (Course::skips_free_flight && Observer::observes)
      if (outcome_.end != End::none) show_free_flight();
    apply(course_.check(system_, is_on()));
    return result();
  }

 private:
  bool is_on() const { return outcome_.status == Status::ok && outcome_.end == End::none; }

  void apply(const Verdict& verdict) {
    if (verdict.status != Status::ok) give_up(verdict.status);
    if (verdict.end == End::none || !is_on()) return;
    outcome_.end = verdict.end;
    remainder_ = verdict.remainder;
  }
  void give_up(Status why) {
    if (outcome_.status == Status::ok) outcome_.status = why;
  }

  void advance() {
    remember();
    course_.set_time(system_, now_);
    system_.scheme().step();
    now_ += 1.0;
    show(1.0);
    const ContactChanges changes = system_.look([&](double before, double x) {
      course_.touch(now_ - x / (x - before), x > 0.0);  // linear interpolation
    });
    any_closed_ = changes.any_closed;
    outcome_.contacts += changes.opened;
    course_.note(system_, now_, any_closed_);
    system_.after_step();
  }

  /// Checks and limits after each step, the dear ones now and then.
  void after_step() {
    ++steps_;
    apply(course_.after_step(system_, observer_, now_, is_on()));
    if (steps_ % Course::steps_between_checks == 0) {
      apply(course_.check(system_, is_on()));
      if (stop_.time_is_over(Course::steps_between_checks * system_.contact_count())) give_up(Status::time_limit);
    }
    if (steps_ % Course::steps_between_outlooks == 0 && is_on()) apply(course_.look_ahead(system_, now_));
    if (stop_.limits_reached(outcome_.contacts, steps_ * system_.beads())) give_up(Status::event_limit);
    now_ = course_.clock(now_);
  }

  /// No contact is closed and the rates are constant: ends the run if it is over, and else goes to the last step before
  /// the next contact closes.
  void cross_free_flight() {
    const FreeFlightAhead flight = course_.free_flight(system_, now_);
    apply(flight.verdict);
    if (!is_on() || !(flight.steps >= 2.0) || options_.free_flight == FreeFlight::stepped) return;
    const double steps = std::floor(flight.steps) - 1.0;
    remember();
    system_.scheme().coast(steps);
    now_ += steps;
    show(steps);
    system_.after_coast();
  }

  void remember() {
    if constexpr (Observer::observes) system_.remember();
  }
  /// Shows the observer the `steps` just done.
  void show(double steps) {
    if constexpr (Observer::observes) {
      const double dt = system_.dt();
      observer_.until(now_ * dt, [&](double t, auto x, auto u) {
        system_.between(Course::fraction(t / dt, now_, steps), steps, x, u);
      });
    }
  }
  /// Shows the observer the free flight that follows the end of a collision.
  void show_free_flight() {
    observer_.until(std::numeric_limits<double>::infinity(),
                    [&](double t, auto x, auto u) { system_.extrapolate(t / system_.dt() - now_, x, u); });
  }

  Outcome result() {
    if (options_.steps) *options_.steps = steps_;
    system_.fill(outcome_);
    outcome_.t_k = course_.touch_time() * system_.dt();
    if constexpr (requires { outcome_.remainder; }) outcome_.remainder = remainder_;
    return outcome_;
  }

  System& system_;
  Course& course_;
  StopLogic stop_;
  StepOptions options_;
  Observer& observer_;
  double now_ = 0.0;  ///< time in steps, skipped ones included; on a plate since its period began
  double remainder_ = 0.0;
  std::uint64_t steps_ = 0;
  bool any_closed_ = false;
  Outcome outcome_;
};

}  // namespace sigmasweep
