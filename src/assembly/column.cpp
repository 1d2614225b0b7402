#include "assembly/column.hpp"

#include <array>
#include <cmath>
#include <map>

#include "assembly/diameters.hpp"
#include "base/quad.hpp"
#include "base/random.hpp"
#include "sigmasweep/contact/calibration.hpp"
#include "sigmasweep/contact/pair_collision.hpp"
#include "sigmasweep/contact/theory.hpp"
#include "sigmasweep/model/law.hpp"

namespace sigmasweep {
namespace {

/// Masses over the mean bead's: (d_i/d)^3.
template <class Real>
std::vector<Real> masses(const Parameters& p) {
  std::vector<Real> mass;
  for (const double diameter : diameters(p)) {
    const Real over_mean = Real(diameter) / Real(p.d);
    mass.push_back(over_mean * over_mean * over_mean);
  }
  return mass;
}

/// Bead i, at i times the gap from the wall, is shifted by up to half a gap: Sec. IV.
template <class Real>
std::vector<Real> gaps(const Parameters& p, const Real& gap) {
  if (p.random_separation == Flag::no || gap == Real(0)) return {};
  const std::uint64_t key = stream_key(static_cast<std::uint64_t>(p.seed), "separation");
  std::vector<Real> gaps;
  Real before = 0;
  for (std::int64_t i = 0; i < p.N; ++i) {
    const Real shift(unit_interval(random_bits(key, static_cast<std::uint64_t>(i))) - 0.5);
    gaps.push_back(gap * (1 + shift - before));
    before = shift;
  }
  return gaps;
}

/// Remembers damping(), which takes milliseconds: a sweep asks for few values, many times.
double known_damping(Exponents e, double k, double eps) {
  constexpr std::size_t most = 256;
  thread_local std::map<std::array<double, 3>, double> known;
  const std::array<double, 3> key{e.beta, e.gamma, eps};  // k follows from beta
  if (const auto found = known.find(key); found != known.end()) return found->second;
  if (known.size() >= most) known.clear();
  return known[key] = damping(e, k, 1.0, eps);
}

/// The pair's law per reduced mass, with length v0 tc and time tc as units; from (tc, epsilon) or from D_n.
PairLaw reduced_pair(const Parameters& p, Exponents e) {
  const double k = theory::stiffness(e, 1.0, 1.0);
  const double b =
      p.K_over_m > 0.0 ? 2.0 * p.D_n * p.tc * std::pow(p.v0 * p.tc, e.gamma) : known_damping(e, k, p.epsilon);
  return {e, k, b};
}

/// Springs and dashpots over the bead mass m: K/m = k/2 and D_n = b/2, as m_red = m/2 and m_ij = m for a pair of equal
/// beads. For the linear law k = omega0^2 and b = 2 mu, Eqs. (3), (5). Overdamped pairs have no tc and epsilon, so
/// K_over_m and D_n are used directly where they are given.
template <class Real>
struct Stiffness {
  Real K, C;
};
template <class Real>
Stiffness<Real> stiffness(const Parameters& p, const Real& speed, const Real& tc) {
  const Exponents e = exponents(p);
  if (e.linear() && p.K_over_m > 0.0) {
    const Real unit = Real(p.tc) / tc;  // of time, s
    return {Real(p.K_over_m) * unit * unit / 2, Real(p.D_n) * unit};
  }
  if (e.linear()) {
    const Oscillator<Real> pair = oscillator<Real>(tc, Real(p.epsilon));
    return {pair.omega0_2 / 2, pair.mu};
  }
  using std::pow;
  const PairLaw pair = reduced_pair(p, e);
  const Real length = speed * tc;
  return {Real(pair.k / 2) / (tc * tc * pow(length, Real(e.beta))),
          Real(pair.b / 2) / (tc * pow(length, Real(e.gamma)))};
}

/// At the wall the bead moves with its whole mass: the pair's K and D_n for Wall::paper; twice both for Wall::matched,
/// which gives the bead a pair's relative motion.
template <class Real>
Column<Real> column(const Parameters& p, Real gap, Real speed, Real tc) {
  const Real eps(p.epsilon);
  const auto [K, C] = stiffness<Real>(p, speed, tc);
  const bool matched = p.wall == Wall::matched;
  return {.N = p.N,
          .gap = gap,
          .speed = speed,
          .tc = tc,
          .eps = eps,
          .eps_wall = matched || eps == Real(0) ? eps : wall_restitution<Real>(eps),
          .K = K,
          .C = C,
          .K_wall = matched ? Real(2 * K) : K,
          .C_wall = matched ? Real(2 * C) : C,
          .exponents = exponents(p),
          .mass = masses<Real>(p),
          .gaps = gaps<Real>(p, gap)};
}

}  // namespace

template <class Real>
Column<Real> reduced_column(const Parameters& p) {
  return column<Real>(p, Real(p.sigma), Real(1), Real(1));
}

template <class Real>
Column<Real> si_column(const Parameters& p) {
  return column<Real>(p, Real(p.s0), Real(p.v0), Real(p.tc));
}

template Column<double> reduced_column(const Parameters&);
template Column<long double> reduced_column(const Parameters&);
template Column<Quad> reduced_column(const Parameters&);
template Column<double> si_column(const Parameters&);
template Column<long double> si_column(const Parameters&);
template Column<Quad> si_column(const Parameters&);

}  // namespace sigmasweep
