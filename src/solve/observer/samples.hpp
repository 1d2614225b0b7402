#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace sigmasweep {

/// The observer of a run that is not recorded. Solvers compute nothing for it.
struct NullObserver {
  static constexpr bool observes = false;
};

/// The observer that records a column: overlaps x and rates u = x' of all contacts at given times, in the solver's
/// units. Before a solver changes its state, it calls until() with the time up to which the state is valid.
class Samples {
 public:
  static constexpr bool observes = true;

  Samples(std::vector<double> times, std::size_t contacts)
      : times_(std::move(times)),
        contacts_(contacts),
        x_(times_.size() * contacts, std::numeric_limits<double>::quiet_NaN()),
        u_(x_) {}

  /// Takes the samples up to and at `time`. `state(t, x, u)` writes overlaps and rates at t.
  template <class State>
  void until(double time, State&& state) {
    for (; !done() && times_[taken_] <= time; ++taken_)
      state(times_[taken_], std::span(x_).subspan(taken_ * contacts_, contacts_),
            std::span(u_).subspan(taken_ * contacts_, contacts_));
  }
  /// Whether all samples are taken, so that the solver may stop.
  bool done() const { return taken_ == times_.size(); }

  std::span<const double> x(std::size_t sample) const { return std::span(x_).subspan(sample * contacts_, contacts_); }
  std::span<const double> u(std::size_t sample) const { return std::span(u_).subspan(sample * contacts_, contacts_); }

 private:
  std::vector<double> times_;
  std::size_t contacts_, taken_ = 0;
  std::vector<double> x_, u_;
};

/// The observer that records a vibrated column. Its solvers count time from the start of the plate's present period.
class VibratedSamples {
 public:
  static constexpr bool observes = true;

  VibratedSamples(Samples& samples, double period) : samples_(samples), period_(period) {}

  template <class State>
  void until(double time, State&& state) {
    const double begun = static_cast<double>(periods_) * period_;
    samples_.until(begun + time, [&](double when, auto x, auto u) { state(std::min(when - begun, time), x, u); });
  }
  void end_period(double /*energy*/, double /*in*/, double /*lost*/) { ++periods_; }
  bool done() const { return samples_.done(); }

 private:
  Samples& samples_;
  double period_;
  std::int64_t periods_ = 0;
};

}  // namespace sigmasweep
