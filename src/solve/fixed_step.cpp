#include "sigmasweep/solve/fixed_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "fixed_step_chain.hpp"
#include "fixed_step_gear5.hpp"
#include "fixed_step_rk4.hpp"
#include "fixed_step_verlet.hpp"
#include "in_si.hpp"
#include "sigmasweep/solve/exact.hpp"

namespace sigmasweep {

Chain::Chain(const Column<double>& column, double dt)
    : contacts(static_cast<std::size_t>(column.N)),
      blocks(Lanes::padded(contacts) / Lanes::width),
      K(contacts), C(contacts), g(contacts),
      x(contacts, -std::numeric_limits<double>::max()),
      u(contacts) {
  for (std::size_t k = 0; k < contacts; ++k) {
    K[k] = (k == 0 ? column.K_wall : column.K) * dt * dt;
    C[k] = (k == 0 ? column.C_wall : column.C) * dt;
    g[k] = k == 0 ? 1.0 : 2.0;
    x[k] = -column.gap;
  }
  u[0] = column.speed * dt;
}

namespace {

/// High derivatives fade to denormal numbers in free flight, on which the processor is about twenty times slower.
class DenormalsAreZero {
#if defined(__SSE2__)
 public:
  DenormalsAreZero() { _mm_setcsr(before_ | 0x8040u); }  // flush to zero, denormals are zero
  ~DenormalsAreZero() { _mm_setcsr(before_); }
  DenormalsAreZero(const DenormalsAreZero&) = delete;

 private:
  unsigned before_ = _mm_getcsr();
#endif
};

/// Steps a scheme from the start to the end of a collision and keeps the record.
template <class Scheme>
class Run {
 public:
  Run(const Column<double>& column, double dt, const FixedStepOptions& options)
      : column_(column), options_(options), dt_(dt), chain_(column, dt), scheme_(chain_), before_(chain_.x),
        deepest_(chain_.contacts) {
    if (options_.step_limit == 0.0) options_.step_limit = 1e11 / static_cast<double>(column.N);
    lowest_energy_ = start_energy_ = energy();
  }

  Outcome<double> operator()() {
    while (outcome_.status == Status::ok && outcome_.end == End::none) {
      if (!any_closed_ && scheme_.coasts()) cross_free_flight();
      if (outcome_.end != End::none) break;
      advance();
      if (++steps_ % 16 == 0) check_energy();
      if (static_cast<double>(steps_) > options_.step_limit && outcome_.status == Status::ok)
        outcome_.status = Status::event_limit;
    }
    if (outcome_.status == Status::ok) check_energy();
    return result();
  }

 private:
  void advance() {
    scheme_.step();
    now_ += 1.0;
    const double* x = scheme_.x();
    double* before = before_.data();
    double* deepest = deepest_.data();
    if ((x[0] > 0.0) != (before[0] > 0.0)) wall_changed(x[0]);
    const std::size_t lanes = chain_.lanes();
    std::int64_t closed = 0, opened = 0;
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
      closed |= x[k] > 0.0;
      opened += (before[k] > 0.0) & !(x[k] > 0.0);
      deepest[k] = x[k] > deepest[k] ? x[k] : deepest[k];
      before[k] = x[k];
    }
    any_closed_ = closed != 0;
    outcome_.contacts += static_cast<std::uint64_t>(opened);
  }

  /// When the wall's contact closed or opened, by linear interpolation within the step just done.
  void wall_changed(double x) {
    const double before = before_[0];
    const double when = now_ - x / (x - before);
    if (x > 0.0 && first_wall_ < 0.0) first_wall_ = when;
    last_wall_ = when;
  }

  /// No contact is closed and the rates are constant: see whether it is over, and if not go to the last step before
  /// the next contact closes.
  void cross_free_flight() {
    double steps = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < chain_.contacts; ++k)
      if (scheme_.u()[k] > 0.0) steps = std::min(steps, -scheme_.x()[k] / scheme_.u()[k]);
    if (steps == std::numeric_limits<double>::infinity()) {
      outcome_.end = End::separated;
      return;
    }
    if (steps < 2.0) return;
    if (residual_dissipation<double>(velocities(), chain_.u[0]) < options_.settle) {
      outcome_.end = End::settled;
      return;
    }
    if (!options_.skip_free_flight) return;
    steps = std::floor(steps) - 1.0;
    scheme_.coast(steps);
    now_ += steps;
    // Only where a gap is so wide that its rounding exceeds a step.
    for (std::size_t k = 0; k < chain_.contacts; ++k)
      if (scheme_.x()[k] > 0.0) scheme_.touch(k);
    before_copy();
  }

  void before_copy() { std::copy_n(scheme_.x(), chain_.contacts, before_.data()); }

  /// v_k = -(u_0 + ... + u_k), lengths a step.
  std::vector<double> velocities() const {
    std::vector<double> v(chain_.contacts);
    double sum = 0.0;
    for (std::size_t k = 0; k < chain_.contacts; ++k) v[k] = -(sum += scheme_.u()[k]);
    return v;
  }

  double energy() const {
    double v = 0.0, E = 0.0;
    for (std::size_t k = 0; k < chain_.contacts; ++k) {
      const double x = scheme_.x()[k];
      v += scheme_.u()[k];
      E += v * v;
      if (x > 0.0) E += chain_.K[k] * x * x;
    }
    return 0.5 * E;
  }

  /// Energy can only fall. If it rises again by 5 % of what there was at the start, or beyond all numbers, then that
  /// is the scheme's doing.
  void check_energy() {
    const double E = energy();
    if (!(E <= lowest_energy_ + 0.05 * start_energy_)) outcome_.status = Status::unstable;
    lowest_energy_ = std::min(lowest_energy_, E);
  }

  Outcome<double> result() {
    outcome_.velocity = velocities();
    for (double& v : outcome_.velocity) v /= dt_;
    for (std::size_t k = 0; k < chain_.contacts; ++k) outcome_.x_max = std::max(outcome_.x_max, deepest_[k]);
    outcome_.t_k = (last_wall_ - std::max(first_wall_, 0.0)) * dt_;
    return outcome_;
  }

  const Column<double>& column_;
  FixedStepOptions options_;
  double dt_;
  Chain chain_;
  Scheme scheme_;
  Lanes before_, deepest_;
  double now_ = 0.0;  ///< time in steps, crossed ones included
  double first_wall_ = -1.0, last_wall_ = 0.0;
  double start_energy_ = 0.0, lowest_energy_ = 0.0;
  std::uint64_t steps_ = 0;
  bool any_closed_ = false;
  Outcome<double> outcome_;
};

}  // namespace

Outcome<double> fixed_step_collision(const Column<double>& column, Integrator integrator, double dt,
                                     const FixedStepOptions& options) {
  const DenormalsAreZero guard;
  switch (integrator) {
    case Integrator::gear5: return Run<Gear5>(column, dt, options)();
    case Integrator::verlet: return Run<Verlet>(column, dt, options)();
    case Integrator::rk4: return Run<RungeKutta4>(column, dt, options)();
    case Integrator::exact: break;
  }
  throw std::invalid_argument("fixed_step_collision: not an integrator of fixed step");
}

Collision simulate_fixed_step(const Parameters& parameters) {
  const Column<double> column = reduced_column<double>(parameters);
  const double settle = 1e-3 * parameters.tolerance;
  const Outcome<double> outcome =
      fixed_step_collision(column, parameters.integrator, 1.0 / parameters.steps_per_tc, {.settle = settle});
  Collision collision = in_si(outcome, parameters);
  if (!is_success(collision.status)) return collision;
  const Collision exact = simulate_exact(parameters);
  // Both lie between 0 and 1 where nothing better is known.
  const double worst = std::max(collision.eps_eff, std::fabs(1.0 - collision.eps_eff));
  const double error = std::fabs(collision.eps_eff - exact.eps_eff) + exact.eps_eff_error;
  collision.eps_eff_error = error <= worst ? error : worst;
  return collision;
}

}  // namespace sigmasweep
