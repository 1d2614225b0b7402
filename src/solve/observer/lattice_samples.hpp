#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "base/vec2.hpp"
#include "solve/observer/samples.hpp"

namespace sigmasweep {

/// The observer that records a lattice: displacements from the sites and velocities of all beads at given times, in the
/// solver's units. Time counts from the start of the fall, or of the plate's motion. See Samples.
class LatticeSamples {
 public:
  static constexpr bool observes = true;
  using Vectors = std::span<Vec2<double>>;

  LatticeSamples(std::vector<double> times, std::size_t beads)
      : times_(std::move(times)), beads_(beads), q_(times_.size() * beads, nowhere), v_(q_) {}

  /// Takes the samples up to and at `time`. `state(t, q, v)` writes displacements and velocities at t.
  template <class State>
  void until(double time, State&& state) {
    for (; !done() && times_[taken_] <= time; ++taken_) state(times_[taken_], q(taken_), v(taken_));
  }
  bool done() const { return taken_ == times_.size(); }

  Vectors q(std::size_t sample) { return std::span(q_).subspan(sample * beads_, beads_); }
  Vectors v(std::size_t sample) { return std::span(v_).subspan(sample * beads_, beads_); }

 private:
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  static constexpr Vec2<double> nowhere{nan, nan};
  std::vector<double> times_;
  std::size_t beads_, taken_ = 0;
  std::vector<Vec2<double>> q_, v_;
};

/// The observer that records a vibrated lattice. Its solvers count time from the start of the plate's present period.
class VibratedLatticeSamples {
 public:
  static constexpr bool observes = true;

  VibratedLatticeSamples(LatticeSamples& samples, double period) : samples_(samples), period_(period) {}

  template <class State>
  void until(double time, State&& state) {
    const double begun = static_cast<double>(periods_) * period_;
    samples_.until(begun + time, [&](double when, auto q, auto v) { state(std::min(when - begun, time), q, v); });
  }
  void end_period(double /*energy*/, double /*in*/, double /*lost*/) { ++periods_; }
  bool done() const { return samples_.done(); }

 private:
  LatticeSamples& samples_;
  double period_;
  std::int64_t periods_ = 0;
};

}  // namespace sigmasweep
