#include <algorithm>
#include <cmath>

#include "assembly/energy_on_plate.hpp"
#include "solve/fixed_step/column/vibrated.hpp"
#include "solve/fixed_step/dispatch.hpp"
#include "solve/observer/samples.hpp"
#include "solve/observer/vibration_statistics.hpp"

namespace sigmasweep {
namespace {

/// Steps a scheme through the periods of the plate, each of the same whole number of steps.
template <class Chain, template <class> class Scheme, class Watcher>
class PlateRun {
 public:
  PlateRun(const Column<double>& column, const Plate& plate, double steps_per_period, Watcher& watcher)
      : column_(column),
        plate_(plate),
        steps_(steps_per_period),
        dt_(plate.period() / steps_per_period),
        chain_(column, dt_, plate),
        scheme_(chain_),
        x_(contacts()),
        u_(contacts()),
        closed_(contacts()),
        watcher_(watcher) {
    for (std::size_t k = 0; k < contacts(); ++k) {
      closed_[k] = scheme_.x()[k] > 0.0;
      weight_ += plate.g / column.inverse_mass(k);
    }
  }

  Outcome<double> operator()(ComputeBudget* budget) {
    const double start = energy();
    lost_before_ = power_lost();
    in_before_ = power_in(0.0);
    while (!watcher_.done() && outcome_.status == Status::ok) {
      for (double step = 0.0; step < steps_ && outcome_.status == Status::ok; ++step) {
        advance(step);
        if (budget && budget->is_over(contacts())) outcome_.status = Status::time_limit;
      }
      const double gain = energy() - start;
      path_ += 4.0 * plate_.A0;
      if (is_out_of_nothing(gain) && outcome_.status == Status::ok) outcome_.status = Status::unstable;
      if (outcome_.status == Status::ok) watcher_.end_period(gain, in_, lost_);
    }
    if (outcome_.status == Status::ok) outcome_.end = End::periods;
    return outcome_;
  }

 private:
  std::size_t contacts() const { return chain_.contacts; }

  void advance(double step) {
    std::copy_n(scheme_.x(), contacts(), x_.begin());
    std::copy_n(scheme_.u(), contacts(), u_.begin());
    chain_.set_time(step);
    scheme_.step();
    for (std::size_t k = 0; k < contacts(); ++k) {
      const bool closed = scheme_.x()[k] > 0.0;
      outcome_.contacts += closed_[k] && !closed;
      closed_[k] = closed;
      outcome_.x_max = std::max(outcome_.x_max, scheme_.x()[k]);
    }
    const double lost = power_lost(), in = power_in(step + 1.0);
    lost_ += 0.5 * (lost_before_ + lost);  // the trapezoidal rule
    in_ += 0.5 * (in_before_ + in);
    lost_before_ = lost;
    in_before_ = in;
    watcher_.until((step + 1.0) * dt_, [&](double t, auto x, auto u) {
      for (std::size_t k = 0; k < contacts(); ++k) {
        const BetweenSteps now(t / dt_ - step, 1.0, x_[k], u_[k], scheme_.x()[k], scheme_.u()[k]);
        x[k] = now.x;
        u[k] = now.u / dt_;
      }
    });
  }

  /// A step's, in the solver's units.
  double power_lost() const {
    double sum = 0.0;
    for (std::size_t k = 0; k < contacts(); ++k) {
      const double x = scheme_.x()[k], u = scheme_.u()[k];
      sum += where_closed(chain_.force, 0.0, chain_.C[k], x, u) * u;
    }
    return sum / (dt_ * dt_);
  }
  double power_in(double step) const {
    const double force = where_closed(chain_.force, chain_.K[0], chain_.C[0], scheme_.x()[0], scheme_.u()[0]);
    return force / dt_ * plate_.speed(step * dt_);
  }
  /// Energy that neither the plate brought nor the contacts left, or that is beyond all numbers, is the scheme's doing:
  /// half of what the plate exchanges with the column's weight on its path. Stable steps stay far below.
  bool is_out_of_nothing(double gain) const {
    return !(gain - in_ + lost_ <= 0.5 * std::max(std::fabs(in_), weight_ * path_));
  }
  /// At the beginning of a period.
  double energy() const {
    std::vector<double> u(scheme_.u(), scheme_.u() + contacts());
    for (double& each : u) each /= dt_;
    return energy_on_plate(column_, plate_, 0.0, {scheme_.x(), contacts()}, u);
  }

  const Column<double>& column_;
  Plate plate_;
  double steps_, dt_;
  Chain chain_;
  Scheme<Chain> scheme_;
  std::vector<double> x_, u_;  ///< before the step
  std::vector<std::uint8_t> closed_;
  Watcher& watcher_;
  double weight_ = 0.0, path_ = 0.0;
  double lost_ = 0.0, in_ = 0.0, lost_before_ = 0.0, in_before_ = 0.0;
  Outcome<double> outcome_;
};

}  // namespace

template <class Watcher>
Outcome<double> follow_by_fixed_steps(const Column<double>& column, const Plate& plate, Integrator integrator,
                                      double dt, Watcher& watcher, ComputeBudget* budget) {
  const double steps = std::ceil(plate.period() / dt);
  return with_law(column, [&]<class Force, bool Uneven>() {
    return with_scheme(integrator, [&]<template <class> class Scheme>() {
      return PlateRun<Chain<Force, Uneven, Plate>, Scheme, Watcher>(column, plate, steps, watcher)(budget);
    });
  });
}

template Outcome<double> follow_by_fixed_steps(const Column<double>&, const Plate&, Integrator, double,
                                               VibrationStatistics&, ComputeBudget*);
template Outcome<double> follow_by_fixed_steps(const Column<double>&, const Plate&, Integrator, double,
                                               VibratedSamples&, ComputeBudget*);

}  // namespace sigmasweep
