#include "solve/reference/normal_modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "assembly/energies.hpp"
#include "solve/reference/damped_modes.hpp"
#include "solve/stop_logic.hpp"

namespace sigmasweep {
namespace {

using Real = long double;

/// Overlap or gap and its rate.
struct State {
  Real x, u;
};

/// Closed contacts lo..hi that move together, beads lo-1..hi (bead -1 is the wall); contacts and beads from 0.
struct Run {
  std::size_t lo, hi;
  const DampedModes* modes;
  std::vector<Real> y, v;                   ///< the modes, at the present time
  std::vector<Real> y_end, v_end;           ///< and at the end of the step
  std::vector<Real> second, third, fourth;  ///< bounds of the derivatives of y from now on
  Real drift;                               ///< velocity of the centre of mass; 0 at the wall
  bool holds(std::size_t k) const { return lo <= k && k <= hi; }
};

class NormalModesColumn {
 public:
  NormalModesColumn(const Column<Real>& column, const RunLimits& limits)
      : column_(column),
        stop_(limits, 100'000 + 20 * column.contacts() * column.contacts(), 2'000'000'000),
        N_(column.contacts()),
        closed_(N_, 0),
        run_of_(N_, nullptr),
        next_(N_),
        slack_(1e-18L * static_cast<Real>(N_)),
        matched_(column.K_wall != column.K) {
    for (std::size_t k = 0; k < N_; ++k) now_.push_back({-column.initial_gap(k), 0});
    now_[0].u = column.speed;
  }

  Outcome<Real> operator()() {
    begin();
    while (outcome_.status == Status::ok && outcome_.end == End::none) {
      if (runs_.empty())
        advance_free();
      else
        step();
      outcome_.status = stop_.why_stop(outcome_.contacts, work_, 1);
      if (!std::isfinite(now_[0].u)) outcome_.status = Status::non_finite;
    }
    outcome_.velocity = velocities();
    outcome_.t_k = wall_opened_;
    outcome_.x_max = std::numeric_limits<Real>::quiet_NaN();
    return outcome_;
  }

 private:
  /// The clock starts when the first bead meets the wall. Contacts that touch from there on upwards close with it: the
  /// first of their derivatives that is not zero is positive.
  void begin() {
    now_[0].x = 0;
    closed_[0] = 1;
    for (std::size_t k = 1; k < N_ && now_[k].x == 0; ++k) closed_[k] = 1;
    regroup();
  }

  std::vector<Real> velocities() const {
    std::vector<Real> v(N_);
    Real sum = 0;
    for (std::size_t k = 0; k < N_; ++k) v[k] = -(sum += now_[k].u);
    return v;
  }

  /// No contact is closed: to the next that closes.
  void advance_free() {
    constexpr Real standstill = 1e-17L;
    Real t = std::numeric_limits<Real>::infinity();
    std::size_t first = 0;
    for (std::size_t k = 0; k < N_; ++k) {
      const Real when = now_[k].u > standstill * column_.speed ? std::max<Real>(0, -now_[k].x / now_[k].u) : t;
      if (when < t) t = when, first = k;
    }
    if (t == std::numeric_limits<Real>::infinity()) {
      outcome_.end = End::separated;
      return;
    }
    if (residual_dissipation<Real>(velocities(), column_.speed) < stop_.settle()) {
      outcome_.end = End::settled;
      return;
    }
    for (State& s : now_) s.x += s.u * t;
    time_ += t;
    now_[first].x = 0;
    closed_[first] = 1;
    regroup();
  }

  /// The runs of closed contacts, those that are as before with their modes as they are.
  void regroup() {
    std::vector<Run> before = std::move(runs_);
    runs_.clear();
    const std::vector<Real> v = velocities();
    for (std::size_t k = 0; k < N_; ++k) {
      if (!closed_[k]) continue;
      const std::size_t lo = k;
      while (k + 1 < N_ && closed_[k + 1]) ++k;
      const auto same = std::ranges::find_if(before, [&](const Run& run) { return run.lo == lo && run.hi == k; });
      runs_.push_back(same != before.end() ? std::move(*same) : new_run(lo, k, v));
    }
    for (const Run*& run : run_of_) run = nullptr;
    for (Run& run : runs_)
      for (std::size_t k = run.lo; k <= run.hi; ++k) run_of_[k] = &run;
  }

  Run new_run(std::size_t lo, std::size_t hi, const std::vector<Real>& velocity) {
    const std::size_t c = hi - lo + 1;
    const RunKind kind = lo > 0 ? RunKind::free : matched_ ? RunKind::at_matched_wall : RunKind::at_wall;
    Run run{lo, hi, &tables_.of(kind, c), std::vector<Real>(c), std::vector<Real>(c), {}, {}, {}, {}, {}, 0};
    for (std::size_t m = 0; m < c; ++m)
      for (std::size_t j = 0; j < c; ++j) {
        run.y[j] += run.modes->analysis[m * c + j] * now_[lo + m].x;
        run.v[j] += run.modes->analysis[m * c + j] * now_[lo + m].u;
      }
    if (lo > 0)
      for (std::size_t bead = lo - 1; bead <= hi; ++bead) run.drift += velocity[bead] / static_cast<Real>(c + 1);
    bound(run);
    work_ += 3 * c * c;
    return run;
  }

  /// Every derivative of y solves the same equation, and y'^2 + omega^2 y^2 never grows. So
  /// |y^(n)| <= sqrt(y_n^2 + (y_(n+1)/omega)^2) from now on.
  void bound(Run& run) const {
    const std::size_t c = run.y.size();
    for (auto* each : {&run.second, &run.third, &run.fourth}) each->assign(c, 0);
    for (std::size_t j = 0; j < c; ++j) {
      const Real mu2 = run.modes->lambda[j] * column_.C, omega2 = run.modes->lambda[j] * column_.K;
      Real d[6] = {run.y[j], run.v[j]};
      for (int n = 2; n < 6; ++n) d[n] = -mu2 * d[n - 1] - omega2 * d[n - 2];
      const auto size = [&](int n) { return std::sqrt(d[n] * d[n] + d[n + 1] * d[n + 1] / omega2); };
      run.second[j] = size(2);
      run.third[j] = size(3);
      run.fourth[j] = size(4);
    }
  }

  Propagator over(const Run& run, std::size_t j, Real t) const {
    const Real lambda = run.modes->lambda[j];
    return propagator(lambda * column_.C / 2, lambda * column_.K, t);
  }

  /// Of contact k, so long after now.
  State at(std::size_t k, Real t) {
    if (const Run* run = run_of_[k]) {
      const std::size_t c = run->y.size();
      const Real* shape = &run->modes->shape[(k - run->lo) * c];
      State s{0, 0};
      for (std::size_t j = 0; j < c; ++j) {
        const Propagator p = over(*run, j, t);
        s.x += shape[j] * (p.yy * run->y[j] + p.yv * run->v[j]);
        s.u += shape[j] * (p.vy * run->y[j] + p.vv * run->v[j]);
      }
      work_ += 10 * c;
      return s;
    }
    const State below = edge(k, -1, t), above = edge(k, +1, t);
    return {now_[k].x + below.x - above.x, below.u - above.u};
  }

  /// How far the bead below (side -1) or above (+1) the open contact k has moved, and its velocity. Its neighbour on
  /// the other side pushes it: with p'' = F = sum_j shape_j (K y_j + C y_j') for the uppermost bead of a run,
  ///     p(t) - p(0) = drift t - sum_j shape_j (y_j(t) - y_j(0))/lambda_j.
  State edge(std::size_t k, int side, Real t) {
    const Run* run = run_beside(k, side);
    if (run == nullptr) {
      const Real v = side < 0 && k == 0 ? Real(0) : velocity_[side < 0 ? k - 1 : k];
      return {v * t, v};
    }
    const std::size_t c = run->y.size();
    const Real* analysis = &run->modes->analysis[side < 0 ? (c - 1) * c : 0];
    State s{run->drift * t, run->drift};
    for (std::size_t j = 0; j < c; ++j) {
      const Propagator p = over(*run, j, t);
      const Real weight = static_cast<Real>(side) * analysis[j] / run->modes->lambda[j];
      s.x += weight * ((p.yy * run->y[j] + p.yv * run->v[j]) - run->y[j]);
      s.u += weight * (p.vy * run->y[j] + p.vv * run->v[j]);
    }
    work_ += 10 * c;
    return s;
  }

  const Run* run_beside(std::size_t k, int side) const {
    if (side < 0) return k > 0 ? run_of_[k - 1] : nullptr;
    return k + 1 < N_ ? run_of_[k + 1] : nullptr;
  }

  /// |x''''| of contact k from now on.
  Real fourth_derivative(std::size_t k) const {
    Real bound = 0;
    if (const Run* run = run_of_[k]) {
      const std::size_t c = run->y.size();
      for (std::size_t j = 0; j < c; ++j) bound += std::fabs(run->modes->shape[(k - run->lo) * c + j]) * run->fourth[j];
      return bound;
    }
    for (const int side : {-1, 1})  // p'''' = F'' = sum_j shape_j (K y_j'' + C y_j''')
      if (const Run* run = run_beside(k, side)) {
        const std::size_t c = run->y.size();
        const Real* analysis = &run->modes->analysis[side < 0 ? (c - 1) * c : 0];
        for (std::size_t j = 0; j < c; ++j)
          bound += std::fabs(analysis[j]) * (column_.K * run->second[j] + column_.C * run->third[j]);
      }
    return bound;
  }

  /// One step of all runs, or to the first event within it.
  void step() {
    velocity_ = velocities();
    Real span = 0.4L / std::sqrt(4 * column_.K);  // a fraction of the fastest mode's 1/omega
    advance_modes(span);
    for (std::size_t k = 0; k < N_; ++k) next_[k] = end_state(k, span);
    std::size_t event = N_;
    for (std::size_t k = 0; k < N_; ++k) {
      const Real bound = fourth_derivative(k);
      const State end = event == N_ ? next_[k] : State{std::numeric_limits<Real>::quiet_NaN(), 0};
      const Real t = first_crossing(k, span, end, bound);
      if (t < span || (event == N_ && t == span)) span = t, event = k;
    }
    if (event < N_) {
      advance_modes(span);
      for (std::size_t k = 0; k < N_; ++k) next_[k] = end_state(k, span);
    }
    now_ = next_;
    time_ += span;
    for (Run& run : runs_) {
      run.y.swap(run.y_end);
      run.v.swap(run.v_end);
      bound(run);
    }
    if (event < N_) change(event);
  }

  void change(std::size_t k) {
    now_[k].x = closed_[k] ? -slack_ : Real(0);
    closed_[k] = closed_[k] ? 0 : 1;
    if (!closed_[k]) {
      ++outcome_.contacts;
      if (k == 0) wall_opened_ = time_;
    }
    regroup();
  }

  void advance_modes(Real t) {
    for (Run& run : runs_) {
      const std::size_t c = run.y.size();
      run.y_end.resize(c);
      run.v_end.resize(c);
      for (std::size_t j = 0; j < c; ++j) {
        const Propagator p = over(run, j, t);
        run.y_end[j] = p.yy * run.y[j] + p.yv * run.v[j];
        run.v_end[j] = p.vy * run.y[j] + p.vv * run.v[j];
      }
    }
  }

  /// Of contact k after the step for which the modes were advanced.
  State end_state(std::size_t k, Real t) {
    const Run* run = run_of_[k];
    if (run == nullptr) return at(k, t);
    const std::size_t c = run->y.size();
    const Real* shape = &run->modes->shape[(k - run->lo) * c];
    State s{0, 0};
    for (std::size_t j = 0; j < c; ++j) {
      s.x += shape[j] * run->y_end[j];
      s.u += shape[j] * run->v_end[j];
    }
    work_ += 3 * c;
    return s;
  }

  /// What must stay positive: a closed contact's overlap down to -slack, an open one's gap.
  State watched(std::size_t k, const State& s) const {
    return closed_[k] ? State{s.x + slack_, s.u} : State{-s.x, -s.u};
  }

  /// When contact k changes, up to `span`; infinity if it does not. The state at the end may be given (not NaN).
  Real first_crossing(std::size_t k, Real span, const State& end, Real fourth) {
    State a = watched(k, now_[k]);
    if (a.x <= 0 && a.u < 0) return 0;  // an open gap of no width that closes
    a.x = std::max<Real>(a.x, 0);
    const State b = watched(k, std::isnan(end.x) ? at(k, span) : end);
    // Nothing but rounding before the wave gets there: the bound, which is the whole run's, could not say so.
    const auto quiet = [&](const State& s) { return std::fabs(s.x) + span * std::fabs(s.u) < 1e3L * slack_; };
    if (closed_[k] && quiet(a) && quiet(b)) return std::numeric_limits<Real>::infinity();
    return crossing_in(k, 0, a, span, b, fourth, 0);
  }

  /// The cubic through both ends with their slopes is off by at most f s^2 (1-s)^2/24, f = |x''''| h^4, s = t/h; its
  /// Bernstein coefficients say whether it stays positive, or falls all the way; if neither is sure, we look at halves.
  Real crossing_in(std::size_t k, Real ta, const State& a, Real tb, const State& b, Real fourth, int depth) {
    constexpr Real never = std::numeric_limits<Real>::infinity();
    constexpr int deepest = 60;
    const Real h = tb - ta, f = fourth * h * h * h * h;
    const Real inner_a = a.x + h * a.u / 3, inner_b = b.x - h * b.u / 3;
    const bool either = (inner_a >= 0 && 3 * inner_b >= f / 24) || (3 * inner_a >= f / 24 && inner_b >= 0);
    if (b.x > 0 && either) return never;
    const Real slope_off = f / 124;  // sqrt(3)/216
    const bool falls = h * a.u < -slope_off && 3 * (inner_b - inner_a) < -slope_off && h * b.u < -slope_off;
    if (falls) return b.x > 0 ? never : root(k, ta, tb);
    if (depth == deepest || !(ta + h / 2 > ta)) return b.x > 0 ? never : tb;
    const Real tm = ta + h / 2;
    const State m = watched(k, at(k, tm));
    const Real t = crossing_in(k, ta, a, tm, m, fourth, depth + 1);
    if (t < never) return t;
    return m.x <= 0 ? tm : crossing_in(k, tm, m, tb, b, fourth, depth + 1);
  }

  /// Where what is watched falls through zero, once, between ta and tb: Newton, with bisection where that leaves.
  Real root(std::size_t k, Real ta, Real tb) {
    Real t = (ta + tb) / 2;
    for (int n = 0; n < 80 && tb > ta; ++n) {
      const State s = watched(k, at(k, t));
      (s.x > 0 ? ta : tb) = t;
      Real better = t - s.x / s.u;
      if (std::fabs(better - t) <= 1e-19L * std::fabs(t)) return t;
      if (!(better > ta && better < tb)) better = (ta + tb) / 2;
      if (better == t) break;
      t = better;
    }
    return t;
  }

  const Column<Real>& column_;
  StopLogic stop_;
  std::size_t N_;
  ModeTables tables_;
  std::vector<State> now_;
  std::vector<std::uint8_t> closed_;
  std::vector<Run> runs_;
  std::vector<const Run*> run_of_;
  std::vector<State> next_;     ///< at the end of the step
  std::vector<Real> velocity_;  ///< at its start
  Real slack_, time_ = 0, wall_opened_ = 0;
  bool matched_;
  std::uint64_t work_ = 0;
  Outcome<Real> outcome_;
};

}  // namespace

Outcome<long double> normal_modes_collision(const Column<long double>& column, const RunLimits& limits) {
  const bool paper = column.K_wall == column.K && column.C_wall == column.C;
  const bool matched = column.K_wall == 2 * column.K && column.C_wall == 2 * column.C;
  if (!column.is_uniform() || !column.exponents.linear() || !(paper || matched))
    throw std::invalid_argument("normal_modes_collision: beads of one mass and the linear law only");
  return NormalModesColumn(column, limits)();
}

}  // namespace sigmasweep
