#include "sigmasweep/contact/pair_collision.hpp"

#include <array>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/contact_law.hpp"
#include "numerics/dormand_prince.hpp"
#include "sigmasweep/contact/calibration.hpp"
#include "sigmasweep/contact/theory.hpp"
#include "sigmasweep/model/law.hpp"

namespace sigmasweep {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// x'' + b x^gamma x' + k x^(1+beta) = 0 with the units that make x_max without losses and v equal to 1. Near x = 0 the
/// force is not smooth in x or t, but it is in s = x^(1/q): there s is the independent variable,
///     du/ds = a q s^(q-1)/u,  dt/ds = q s^(q-1)/u,
/// and the contact opens at s = 0 exactly; in between it is the time.
class ScaledPair {
 public:
  explicit ScaledPair(const PairLaw& law) : law_(law), q_(clock_exponent(law.exponents)) {}

  PairCollision run() {
    State in{1.0, 0.0};  // u, t as functions of s
    double s = 0.0;
    const auto along_s = [this](const State& y, State& slope, double at) {
      const double dt = q_ * std::pow(at, q_ - 1.0) / y[0];
      slope = {dt * acceleration(std::pow(at, q_), y[0]), dt};
    };
    if (!advance(along_s, in, s, 2.0, [](const State& y, double) { return y[0] < 0.7; })) return stuck();

    State middle{std::pow(s, q_), in[0]};  // x, u as functions of t
    double t = in[1];
    const auto along_t = [this](const State& y, State& slope, double) {
      slope = {y[1], acceleration(std::fmax(y[0], 0.0), y[1])};
    };
    State turned = middle;
    double turned_at = t;
    const auto is_back = [&](const State& y, double at) {
      if (y[1] > 0.0) turned = y, turned_at = at;  // the last state before the turn
      return y[1] < 0.0 && (y[0] < 0.6 * largest_ || y[1] < -0.5);
    };
    if (!advance(along_t, middle, t, 1e9, is_back)) return stuck();
    find_largest(along_t, turned, turned_at);

    State out{middle[1], t};
    s = std::pow(middle[0], 1.0 / q_);
    if (!advance(along_s, out, s, 0.0, [](const State&, double) { return false; })) return stuck();
    return {std::fmin(-out[0], 1.0), out[1], largest_};
  }

 private:
  using State = std::array<double, 2>;
  static constexpr double accuracy = 1e-15;  ///< local

  double acceleration(double x, double u) const {
    return -law_.b * std::pow(x, law_.exponents.gamma) * u - law_.k * std::pow(x, 1.0 + law_.exponents.beta);
  }

  /// From `at` towards `end` until `done`; false where that takes for ever.
  template <class System, class Done>
  bool advance(const System& system, State& y, double& at, double end, Done done) {
    double step = (end > at ? 1.0 : -1.0) * (end == 0.0 ? 0.1 * at : 0.01);
    for (int tries = 0; tries < 5000; ++tries) {
      if (std::fabs(end - at) <= std::fabs(step)) step = end - at;
      State slope, next;
      system(y, slope, at);
      const double error = scheme_.step(system, y, slope, at, step, next) / accuracy;
      const double factor = 0.9 * std::pow(std::fmax(error, 1e-8), -0.125);
      if (!(error <= 1.0)) {
        step *= error < 1e10 ? std::fmax(0.2, std::fmin(factor, 0.5)) : 0.2;
        if (at + step == at) return false;
        continue;
      }
      const bool last = step == end - at;
      y = next;
      at = last ? end : at + step;
      step *= std::fmin(4.0, factor);
      if (last || done(y, at)) return true;
    }
    return false;
  }

  /// The overlap at u = 0, after `y` at time t: Newton's method with one step of the scheme each.
  template <class System>
  void find_largest(const System& system, const State& y, double t) {
    double step = -y[1] / acceleration(y[0], y[1]);
    State slope, there = y;
    system(y, slope, t);
    for (int i = 0; i < 8; ++i) {
      scheme_.step(system, y, slope, t, step, there);
      step -= there[1] / acceleration(there[0], there[1]);
    }
    largest_ = there[0];
  }

  PairCollision stuck() const { return {0.0, infinity, largest_}; }

  PairLaw law_;
  DormandPrince<double, State> scheme_;
  double q_, largest_ = 1.0;
};

}  // namespace

PairCollision collide(const PairLaw& law, double v) {
  if (law.exponents.linear()) {
    const Oscillator<double> pair{law.b / 2.0, law.k};
    const double omega = std::sqrt(pair.omega0_2 - pair.mu * pair.mu);
    if (!(omega > 0.0)) return {0.0, infinity, std::numeric_limits<double>::quiet_NaN()};
    const double deepest = std::atan2(omega, pair.mu) / omega;
    return {restitution(pair), contact_time(pair), v * std::exp(-pair.mu * deepest) / std::sqrt(law.k)};
  }
  const double length = theory::largest_overlap(law, v), time = length / v;
  const PairLaw scaled{law.exponents, 0.5 * (2.0 + law.exponents.beta),
                       law.b * time * std::pow(length, law.exponents.gamma)};
  const PairCollision c = ScaledPair(scaled).run();
  return {c.eps, c.duration * time, c.x_max * length};
}

double damping(Exponents exponents, double k, double v, double eps) {
  if (exponents.linear()) {
    const double L = -std::log(eps), pi = 3.14159265358979323846;
    return 2.0 * std::sqrt(k) * L / std::sqrt(pi * pi + L * L);
  }
  const double first_order = theory::loss({exponents, k, 1.0}, v);  // 1 - eps is about b times this
  if (1.0 - eps < 1e-7) return (1.0 - eps) / first_order;
  const auto excess = [&](double b) { return collide({exponents, k, b}, v).eps - eps; };
  double low = 0.1 * (1.0 - eps) / first_order, high = 2.0 * low;
  while (excess(high) > 0.0) {
    low = high;
    high *= 2.0;
    if (!std::isfinite(high)) return std::numeric_limits<double>::quiet_NaN();
  }
  std::uintmax_t most = 100;
  const auto [a, b] =
      boost::math::tools::toms748_solve(excess, low, high, boost::math::tools::eps_tolerance<double>(50), most);
  return 0.5 * (a + b);
}

}  // namespace sigmasweep
