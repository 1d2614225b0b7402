#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "sigmasweep/solve/simulate.hpp"
#include "sigmasweep/trajectory/trajectory.hpp"
#include "support/parameters.hpp"

/// Soft beads on a vibrated plate, under the linear law.
namespace sigmasweep {
namespace {

constexpr double pi = std::numbers::pi;

Parameters vibrated(std::int64_t N, double epsilon, double tc, double alpha, double frequency = 20.0) {
  return vibrated_column({.tc = tc, .epsilon = epsilon, .frequency = frequency, .alpha = alpha, .N = N});
}

/// A second opinion that knows neither modes nor series nor the frame of the plate: positions in the room, classical
/// Runge-Kutta at a tiny step that is cut where a contact changes (by bisection), in long double.
class PlainColumn {
 public:
  explicit PlainColumn(const Parameters& p) : p_(p), n_(std::size_t(p.N)), y_(2 * n_) {
    const long double mu = -std::log(static_cast<long double>(p.epsilon)) / p.tc;
    K_ = 0.5L * (std::pow(pi_ / p.tc, 2) + mu * mu);  // Eqs. (6), (7); beads of mass 1, reduced mass 1/2
    C_ = mu;
    omega_ = 2.0L * pi_ * p.frequency;
    for (std::size_t i = 0; i < n_; ++i) {
      y_[i] = static_cast<long double>(i + 1) * p.s0;  // heights less those of touching beads
      y_[n_ + i] = p.A0 * omega_;                      // with the plate
    }
    for (std::size_t k = 0; k < n_; ++k) closed_.push_back(overlap(y_, 0.0L, k) >= 0.0L);
  }

  void run_to(long double end, long double h) {
    while (t_ < end) step(std::min(h, end - t_));
  }
  long double height(std::size_t bead) const { return y_[bead]; }
  long double speed(std::size_t bead) const { return y_[n_ + bead]; }

 private:
  using State = std::vector<long double>;
  static constexpr long double pi_ = 3.14159265358979323846264338327950288L;

  long double plate(long double t) const { return p_.A0 * std::sin(omega_ * t); }
  long double overlap(const State& y, long double t, std::size_t k) const {
    return k == 0 ? plate(t) - y[0] : y[k - 1] - y[k];
  }
  long double rate(const State& y, long double t, std::size_t k) const {
    return k == 0 ? p_.A0 * omega_ * std::cos(omega_ * t) - y[n_] : y[n_ + k - 1] - y[n_ + k];
  }
  State slope(const State& y, long double t) const {
    State dy(2 * n_);
    for (std::size_t i = 0; i < n_; ++i) {
      dy[i] = y[n_ + i];
      dy[n_ + i] -= p_.gravity;
    }
    for (std::size_t k = 0; k < n_; ++k) {
      if (!closed_[k]) continue;
      const long double force = K_ * overlap(y, t, k) + C_ * rate(y, t, k);
      dy[n_ + k] += force;
      if (k > 0) dy[n_ + k - 1] -= force;
    }
    return dy;
  }
  State moved(long double h) const {
    const auto plus = [](const State& y, const State& dy, long double by) {
      State sum = y;
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += by * dy[i];
      return sum;
    };
    const State a = slope(y_, t_), b = slope(plus(y_, a, h / 2), t_ + h / 2);
    const State c = slope(plus(y_, b, h / 2), t_ + h / 2), d = slope(plus(y_, c, h), t_ + h);
    State y = y_;
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
    return y;
  }
  bool changes(const State& y, long double t, std::size_t k) const {
    return closed_[k] ? overlap(y, t, k) < 0.0L : overlap(y, t, k) > 0.0L;
  }
  bool any_changes(const State& y, long double t) const {
    for (std::size_t k = 0; k < n_; ++k)
      if (changes(y, t, k)) return true;
    return false;
  }
  void step(long double h) {
    State next = moved(h);
    if (any_changes(next, t_ + h)) {
      long double low = 0.0L, high = h;
      for (int i = 0; i < 60; ++i) {
        const long double middle = (low + high) / 2;
        (any_changes(moved(middle), t_ + middle) ? high : low) = middle;
      }
      h = high;
      next = moved(h);
      for (std::size_t k = 0; k < n_; ++k)
        if (changes(next, t_ + h, k)) closed_[k] = !closed_[k];
    }
    y_ = next;
    t_ += h;
  }

  Parameters p_;
  std::size_t n_;
  State y_;
  long double K_, C_, omega_, t_ = 0.0L;
  std::vector<bool> closed_;
};

/// Heights and velocities against the plain program, from the first period on until chaos takes over: errors grow at
/// each contact. Units of comparison: A0 and A0 omega. The plain program's own error at 500 steps a tc is below 1e-10.
TEST(VibratedSoftSpheres, MovesAsAPlainProgramSays) {
  struct Case {
    std::int64_t N;
    double epsilon, tc, alpha, s0, periods;
  };
  for (const Case& c :
       {Case{1, 0.9, 1e-3, 3.0, 0.0, 2.0}, Case{1, 0.6, 2e-3, 5.0, 1e-3, 2.0}, Case{2, 0.8, 2e-3, 2.0, 0.0, 1.5},
        Case{5, 0.6, 2e-3, 4.0, 1e-4, 1.0}, Case{10, 0.6, 0.7e-3, 2.0, 0.0, 0.75}, Case{3, 1.0, 5e-3, 1.5, 0.0, 1.0},
        Case{9, 0.3, 2e-3, 2.0, 0.0, 1.0}}) {
    SCOPED_TRACE(testing::Message() << "N = " << c.N << ", epsilon = " << c.epsilon << ", tc = " << c.tc);
    Parameters p = vibrated(c.N, c.epsilon, c.tc, c.alpha);
    p.s0 = c.s0;
    p = vibrated_column(p);
    const std::vector<double> times = sample_times(c.periods / p.frequency, 41);
    const Trajectory ours = record(p, times);
    PlainColumn plain(p);
    for (std::size_t s = 0; s < times.size(); ++s) {
      plain.run_to(times[s], p.tc / 500.0);
      for (std::size_t i = 0; i < std::size_t(c.N); ++i) {
        EXPECT_NEAR(ours.z[s * std::size_t(c.N) + i], double(plain.height(i)), 1e-8 * p.A0) << s << ' ' << i;
        EXPECT_NEAR(ours.velocity[s * std::size_t(c.N) + i], double(plain.speed(i)),
                    1e-7 * p.A0 * 2.0 * pi * p.frequency)
            << s << ' ' << i;
      }
    }
  }
}

double largest_difference(const Trajectory& a, const Trajectory& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.z.size(); ++i) largest = std::fmax(largest, std::fabs(a.z[i] - b.z[i]));
  return a.z.size() == b.z.size() ? largest : INFINITY;
}

/// Steps of fixed length go to the same motion, in first order as contacts open and close within a step.
TEST(VibratedSoftSpheres, FixedStepsConverge) {
  for (const Integrator integrator : {Integrator::gear5, Integrator::verlet, Integrator::rk4, Integrator::leapfrog})
    for (const double width : {0.0, 2e-4}) {
      SCOPED_TRACE(testing::Message() << int(integrator) << ' ' << width);
      Parameters p = vibrated(3, 0.7, 2e-3, 3.0);
      p.width = width;
      const std::vector<double> times = sample_times(1.0 / p.frequency, 41);
      const Trajectory exact = record(p, times);
      p.integrator = integrator;
      const auto error = [&](double steps_per_tc) {
        p.steps_per_tc = steps_per_tc;
        return largest_difference(record(p, times), exact) / p.A0;
      };
      const double coarse = error(200.0), fine = error(2000.0), finest = error(20000.0);
      EXPECT_LT(coarse, 1e-2);
      EXPECT_LT(fine, coarse / 3.0);
      EXPECT_LT(finest, fine / 3.0);
      EXPECT_LT(finest, 1e-4);
    }
}

/// Laws that are not linear: by contact events, with the energies in balance, and by steps, which agree with that and
/// with each other, their works balancing ever better.
TEST(VibratedSoftSpheres, NonlinearLaws) {
  for (const Law law : {Law::hertz, Law::hertz_kuwabara_kono}) {
    Parameters p = vibrated(3, 0.7, 1e-3, 3.0);
    p.law = law;
    p.v0 = 0.1;
    const std::vector<double> times = sample_times(1.0 / p.frequency, 41);
    p.integrator = Integrator::rk4;
    p.steps_per_tc = 5000.0;
    const Trajectory by_rk4 = record(p, times);
    p.integrator = Integrator::verlet;
    EXPECT_LT(largest_difference(record(p, times), by_rk4), 1e-4 * p.A0);
    p.integrator = Integrator::exact;
    EXPECT_LT(largest_difference(record(p, times), by_rk4), 1e-4 * p.A0);
    p.periods = 3;
    p.transient = 0;
    const SimulationResult exact = simulate(p);
    ASSERT_EQ(exact.status, Status::ok);
    EXPECT_LT(std::fabs(exact.vibration.imbalance), 1e-9);  // local errors of 1e-12, some thousand steps
    p.integrator = Integrator::verlet;
    double before = INFINITY;
    for (const double steps : {50.0, 500.0, 5000.0}) {
      p.steps_per_tc = steps;
      const SimulationResult c = simulate(p);
      ASSERT_EQ(c.status, Status::ok);
      EXPECT_LT(std::fabs(c.vibration.imbalance), before / 3.0) << steps;
      before = std::fabs(c.vibration.imbalance);
    }
    EXPECT_LT(before, 1e-4);
  }
}

/// The plate's work is what the contacts lose and the column has more, to rounding: integrals along the way on one
/// side, states on the other.
TEST(VibratedSoftSpheres, EnergyBalances) {
  for (const double epsilon : {0.92, 0.6, 0.1})
    for (const double tc : {1e-3, 1e-5, 1e-7})
      for (const double alpha : {0.5, 2.0, 10.0}) {
        Parameters p = vibrated(10, epsilon, tc, alpha);
        p.periods = 12;
        p.transient = 2;
        const SimulationResult c = simulate(p);
        ASSERT_EQ(c.status, Status::ok) << epsilon << ' ' << tc << ' ' << alpha;
        EXPECT_LT(std::fabs(c.vibration.imbalance), 1e-12) << epsilon << ' ' << tc << ' ' << alpha;
        EXPECT_GE(c.vibration.power_lost, 0.0);
      }
}

/// The ends of the parameters: a result, and the energies in balance.
TEST(VibratedSoftSpheres, ExtremeCases) {
  struct Case {
    std::int64_t N;
    double epsilon, tc, alpha, frequency;
    std::int64_t periods;
  };
  for (const Case& c :
       {Case{10, 0.9, 1e-5, 1.001, 20, 30}, Case{10, 0.9, 1e-5, 100, 20, 200}, Case{10, 0.9, 1e-5, 100, 0.1, 100},
        Case{10, 0.6, 1e-5, 2, 0.1, 12}, Case{10, 0.6, 1e-5, 2, 1e4, 100}, Case{10, 0.6, 1e-9, 2, 20, 6},
        Case{10, 0.92, 1e-9, 4, 20, 40}, Case{100, 0.92, 1e-5, 4, 20, 6}, Case{2, 0.92, 1e-5, 4, 20, 10'000},
        Case{1, 0.9, 1e-3, 3, 1000, 200}, Case{5, 0.9, 1e-3, 3, 2000, 200}, Case{1, 0.2, 1e-6, 3, 20, 10'000},
        Case{10, 1.0, 1e-5, 2, 20, 50}, Case{10, 1e-3, 1e-4, 5, 20, 30}}) {
    SCOPED_TRACE(testing::Message() << "N = " << c.N << ", epsilon = " << c.epsilon << ", tc = " << c.tc
                                    << ", alpha = " << c.alpha << ", f = " << c.frequency);
    Parameters p = vibrated(c.N, c.epsilon, c.tc, c.alpha, c.frequency);
    p.periods = c.periods;
    p.transient = 2;
    const SimulationResult result = simulate(p);
    ASSERT_EQ(result.status, Status::ok);
    EXPECT_TRUE(std::isfinite(result.vibration.h_cm));
    EXPECT_LT(std::fabs(result.vibration.imbalance), 1e-11);
  }
}

/// What goes wrong by a step that is too long says so.
TEST(VibratedSoftSpheres, StepsThatMakeEnergyAreUnstable) {
  Parameters p = vibrated(10, 0.3, 1e-4, 2.0);
  p.periods = 20;
  p.transient = 0;
  p.integrator = Integrator::gear5;
  p.steps_per_tc = 16.0;
  EXPECT_EQ(simulate(p).status, Status::unstable);
  p.steps_per_tc = 200.0;
  EXPECT_EQ(simulate(p).status, Status::ok);
  p.integrator = Integrator::verlet;
  p.steps_per_tc = 4.0;
  EXPECT_EQ(simulate(p).status, Status::unstable);
}

/// A column that never leaves the plate, of which the largest overlap is known.
TEST(VibratedSoftSpheres, LargestOverlapOfWhatLies) {
  Parameters p = vibrated(1, 0.05, 1e-3, 0.9, 5.0);
  p.periods = 1;
  p.transient = 0;
  const double by_modes = simulate(p).x_max;
  p.integrator = Integrator::rk4;
  p.steps_per_tc = 1000.0;
  EXPECT_NEAR(by_modes, simulate(p).x_max, 1e-3 * by_modes);
}

/// Below g nothing takes off: the column lies on the plate, compressed by what it carries.
TEST(VibratedSoftSpheres, LiesStillBelowGravity) {
  Parameters p = vibrated(5, 0.8, 1e-5, 0.9);
  p.periods = 50;
  p.transient = 10;
  const SimulationResult c = simulate(p);
  ASSERT_EQ(c.status, Status::ok);
  // Quasi-static: contact k carries the beads above it, x_k = (N - k) g m/K; the mean over a period of the plate's sine
  // vanishes. K/m = (pi^2 + ln^2 eps)/(2 tc^2).
  const double K = 0.5 * (pi * pi + std::pow(std::log(p.epsilon), 2)) / (p.tc * p.tc);
  double height = 0.0, below = 0.0;
  for (int i = 0; i < 5; ++i) height -= (below += (5 - i) * p.gravity / K) / 5.0;
  EXPECT_NEAR(c.vibration.h_cm_excess, height, 1e-6 * std::fabs(height));  // samples see (omega tc N)^2 of it at most
  EXPECT_DOUBLE_EQ(c.vibration.cm_period, 1.0 / p.frequency);
  EXPECT_LT(c.vibration.separation_max, 0.0);
}

}  // namespace
}  // namespace sigmasweep
