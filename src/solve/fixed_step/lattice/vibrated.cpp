#include "solve/fixed_step/lattice/vibrated.hpp"

#include <cmath>

#include "solve/fixed_step/dispatch.hpp"
#include "solve/fixed_step/lattice/system.hpp"
#include "solve/observer/lattice_statistics.hpp"

namespace sigmasweep {
namespace {

/// Steps a lattice through the periods of the plate, as PlateRun (vibrated_fixed_step.cpp) does a column.
template <class Steps, class Watcher>
class LatticePlateRun {
 public:
  LatticePlateRun(const Lattice<double>& lattice, const Plate& plate, double steps_per_period, Watcher& watcher)
      : lattice_(lattice),
        plate_(plate),
        steps_per_period_(steps_per_period),
        dt_(plate.period() / steps_per_period),
        steps_(lattice, dt_, plate),
        watcher_(watcher) {
    for (std::size_t i = 0; i < lattice.count(); ++i) weight_ += plate.g * lattice.mass(i);
  }

  LatticeOutcome<double> operator()(ComputeBudget* budget) {
    const double start = energy();
    lost_before_ = steps_.contacts().lost();
    in_before_ = power_in(0.0);
    while (!watcher_.done() && is_on()) {
      for (double step = 0.0; step < steps_per_period_ && is_on(); ++step) {
        advance(step);
        if (budget && budget->is_over(steps_.contacts().size()) && is_on()) outcome_.status = Status::time_limit;
      }
      const double gain = energy() - start;
      path_ += 4.0 * plate_.A0;
      if (is_out_of_nothing(gain) && is_on()) outcome_.status = Status::unstable;
      if (is_on()) watcher_.end_period(gain, in_ / (dt_ * dt_), lost_ / (dt_ * dt_));
    }
    for (std::size_t i = 0; i < steps_.beads(); ++i) outcome_.velocity.push_back(1.0 / dt_ * steps_.u(i));
    outcome_.x_max = steps_.contacts().deepest();
    if (is_on()) outcome_.end = End::periods;
    return outcome_;
  }

 private:
  bool is_on() const { return outcome_.status == Status::ok; }

  void advance(double step) {
    steps_.remember();
    steps_.motion().set_time(step);
    steps_.scheme().step();
    outcome_.contacts += steps_.contacts().look([](double, double) {}).opened;
    const double lost = steps_.contacts().lost(), in = power_in(step + 1.0);
    lost_ += 0.5 * (lost_before_ + lost);  // the trapezoidal rule
    in_ += 0.5 * (in_before_ + in);
    lost_before_ = lost;
    in_before_ = in;
    watcher_.until((step + 1.0) * dt_, [&](double t, auto q, auto v) { steps_.between(t / dt_ - step, 1.0, q, v); });
    steps_.keep_lists();
  }

  /// A step's, time in steps, as are the sums.
  double power_in(double step) const { return steps_.contacts().lift() * plate_.speed(step * dt_) * dt_; }

  /// As PlateRun has it.
  bool is_out_of_nothing(double gain) const {
    const double in = in_ / (dt_ * dt_), lost = lost_ / (dt_ * dt_);
    return !(gain - in + lost <= 0.5 * std::max(std::fabs(in), weight_ * path_));
  }

  /// At the beginning of a period: kinetic in the room's frame, of gravity (0 for beads on their sites) and elastic.
  double energy() const {
    double sum = 0.5 * steps_.contacts().elastic() / (dt_ * dt_);
    for (std::size_t i = 0; i < steps_.beads(); ++i) {
      const Vec2<double> v = 1.0 / dt_ * steps_.u(i) + Vec2<double>{0.0, plate_.speed(0.0)};
      sum += lattice_.mass(i) * (0.5 * dot(v, v) + plate_.g * steps_.q(i).z);
    }
    return sum;
  }

  const Lattice<double>& lattice_;
  Plate plate_;
  double steps_per_period_, dt_;
  Steps steps_;
  Watcher& watcher_;
  double weight_ = 0.0, path_ = 0.0;
  double lost_ = 0.0, in_ = 0.0, lost_before_ = 0.0, in_before_ = 0.0;
  LatticeOutcome<double> outcome_;
};

}  // namespace

template <class Watcher>
LatticeOutcome<double> fixed_step_vibrated_lattice(const Lattice<double>& lattice, const Plate& plate,
                                                   Integrator integrator, double dt, Watcher& watcher,
                                                   ComputeBudget* budget) {
  const double steps = std::ceil(plate.period() / dt);
  return with_law(lattice.beads, [&]<class Force, bool Uneven>() {
    return with_scheme(integrator, [&]<template <class> class Scheme>() {
      return LatticePlateRun<LatticeSteps<Force, Uneven, Scheme, Plate>, Watcher>(lattice, plate, steps,
                                                                                  watcher)(budget);
    });
  });
}

template LatticeOutcome<double> fixed_step_vibrated_lattice(const Lattice<double>&, const Plate&, Integrator, double,
                                                            LatticeStatistics&, ComputeBudget*);
template LatticeOutcome<double> fixed_step_vibrated_lattice(const Lattice<double>&, const Plate&, Integrator, double,
                                                            VibratedLatticeSamples&, ComputeBudget*);

}  // namespace sigmasweep
