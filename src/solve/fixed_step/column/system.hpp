#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "assembly/energy_on_plate.hpp"
#include "solve/fixed_step/between_steps.hpp"
#include "solve/fixed_step/column/chain.hpp"
#include "solve/fixed_step/driver.hpp"
#include "solve/outcome.hpp"

namespace sigmasweep {

/// A column that a scheme steps: a System of FixedStepDriver.
template <class Force, bool Uneven, class Scheme, class Ground>
class ColumnSystem {
 public:
  using Outcome = sigmasweep::Outcome<double>;
  using Equation = Chain<Force, Uneven, Ground>;
  using Stepper = typename Scheme::template Stepper<Equation>;

  ColumnSystem(const Column<double>& column, double dt, const Ground& ground)
      : column_(column),
        dt_(dt),
        chain_(column, dt, ground),
        scheme_(chain_),
        before_(chain_.x),
        deepest_(chain_.contacts) {}
  ColumnSystem(const ColumnSystem&) = delete;

  double dt() const { return dt_; }
  std::size_t beads() const { return chain_.contacts; }
  std::size_t contact_count() const { return chain_.contacts; }
  const Column<double>& column() const { return column_; }
  const Equation& equation() const { return chain_; }
  Stepper& scheme() { return scheme_; }
  const Stepper& scheme() const { return scheme_; }
  void set_time(double steps) requires(Ground::moves) { chain_.set_time(steps); }

  template <class Touch>
  ContactChanges look(Touch&& touch) {
    const double* x = scheme_.x();
    double* before = before_.data();
    double* deepest = deepest_.data();
    if ((x[0] > 0.0) != (before[0] > 0.0)) touch(before[0], x[0]);
    const std::size_t lanes = chain_.lanes();
    std::int64_t closed = 0, opened = 0;
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
      closed |= x[k] > 0.0;
      opened += (before[k] > 0.0) & !(x[k] > 0.0);
      deepest[k] = x[k] > deepest[k] ? x[k] : deepest[k];
      before[k] = x[k];
    }
    return {static_cast<std::uint64_t>(opened), closed != 0};
  }
  void after_step() {}
  /// Only where a gap is so wide that its rounding exceeds a step a contact has closed.
  void after_coast() {
    for (std::size_t k = 0; k < beads(); ++k)
      if (scheme_.x()[k] > 0.0) scheme_.touch(k);
    std::copy_n(scheme_.x(), beads(), before_.data());
  }

  /// Overlaps before the step are those of the last look().
  void remember() { rates_before_.assign(scheme_.u(), scheme_.u() + beads()); }
  template <class Numbers>
  void between(double s, double steps, Numbers&& x, Numbers&& u) const {
    for (std::size_t k = 0; k < beads(); ++k) {
      const BetweenSteps now(s, steps, before_[k], rates_before_[k], scheme_.x()[k], scheme_.u()[k]);
      x[k] = now.x;
      u[k] = now.u / dt_;
    }
  }
  template <class Numbers>
  void extrapolate(double steps, Numbers&& x, Numbers&& u) const {
    for (std::size_t k = 0; k < beads(); ++k) {
      x[k] = scheme_.x()[k] + scheme_.u()[k] * steps;
      u[k] = scheme_.u()[k] / dt_;
    }
  }

  /// Velocities of the beads, v_k = -(u_0 + ... + u_k), lengths a step.
  std::vector<double> velocities() const {
    std::vector<double> v(beads());
    double sum = 0.0;
    for (std::size_t k = 0; k < beads(); ++k) v[k] = -(sum += scheme_.u()[k]);
    return v;
  }
  double energy() const {
    double v = 0.0, E = 0.0;
    for (std::size_t k = 0; k < beads(); ++k) {
      const double x = scheme_.x()[k];
      v += scheme_.u()[k];
      E += column_.mass.empty() ? v * v : column_.mass[k] * v * v;
      if (x > 0.0) E += chain_.force.twice_elastic_energy(chain_.K[k], x);
    }
    return 0.5 * E;
  }

  /// Power that the dashpots take, in the solver's units for a time step.
  double power_lost() const requires(Ground::moves) {
    double sum = 0.0;
    for (std::size_t k = 0; k < beads(); ++k) {
      const double x = scheme_.x()[k], u = scheme_.u()[k];
      sum += where_closed(chain_.force, 0.0, chain_.C[k], x, u) * u;
    }
    return sum / (dt_ * dt_);
  }
  /// Power of the plate at a time in steps.
  double power_in(const Ground& plate, double now) const requires(Ground::moves) {
    const double force = where_closed(chain_.force, chain_.K[0], chain_.C[0], scheme_.x()[0], scheme_.u()[0]);
    return force / dt_ * plate.speed(now * dt_);
  }
  /// Works are divided by this to have the solver's units.
  double work_unit() const { return 1.0; }
  double weight(const Ground& plate) const requires(Ground::moves) {
    double sum = 0.0;
    for (std::size_t k = 0; k < beads(); ++k) sum += plate.g / column_.inverse_mass(k);
    return sum;
  }
  /// Energy at the beginning of a period, gravity included.
  double energy_on(const Ground& plate) const requires(Ground::moves) {
    std::vector<double> u(scheme_.u(), scheme_.u() + beads());
    for (double& each : u) each /= dt_;
    return energy_on_plate(column_, plate, 0.0, {scheme_.x(), beads()}, u);
  }

  void fill(Outcome& outcome) const {
    outcome.velocity = velocities();
    for (double& v : outcome.velocity) v /= dt_;
    for (std::size_t k = 0; k < beads(); ++k) outcome.x_max = std::max(outcome.x_max, deepest_[k]);
  }

 private:
  const Column<double>& column_;
  double dt_;
  Equation chain_;
  Stepper scheme_;
  AlignedLanes before_, deepest_;     ///< overlaps at the last look, and the largest ones
  std::vector<double> rates_before_;  ///< for the observer
};

}  // namespace sigmasweep
