#include "sigmasweep/solve/column.hpp"

#include "sigmasweep/scene/calibration.hpp"
#include "sigmasweep/scene/real.hpp"

namespace sigmasweep {
namespace {

/// Springs and dashpots over the bead mass m: with m_red = m/2 and m_ij = m the pair has K/m = omega0^2/2 and
/// D_n = mu, Eqs. (3), (5). At the wall the bead moves with its whole mass: the pair's K and D_n for Wall::paper;
/// twice both for Wall::matched, which gives the wall the pair's omega0 and mu.
template <class Real>
Column<Real> column(const Parameters& p, Real gap, Real speed, Real tc) {
  const Real eps(p.epsilon);
  const Oscillator<Real> pair = oscillator<Real>(tc, eps);
  const Real K = pair.omega0_2 / 2, C = pair.mu;
  const bool matched = p.wall == Wall::matched;
  return {.N = p.N,
          .gap = gap,
          .speed = speed,
          .tc = tc,
          .eps = eps,
          .eps_wall = matched ? eps : wall_restitution<Real>(eps),
          .K = K,
          .C = C,
          .K_wall = matched ? Real(2 * K) : K,
          .C_wall = matched ? Real(2 * C) : C};
}

}  // namespace

template <class Real>
Column<Real> reduced_column(const Parameters& p) { return column<Real>(p, Real(p.sigma), Real(1), Real(1)); }

template <class Real>
Column<Real> si_column(const Parameters& p) { return column<Real>(p, Real(p.s0), Real(p.v0), Real(p.tc)); }

template Column<double> reduced_column(const Parameters&);
template Column<long double> reduced_column(const Parameters&);
template Column<Quad> reduced_column(const Parameters&);
template Column<double> si_column(const Parameters&);
template Column<long double> si_column(const Parameters&);
template Column<Quad> si_column(const Parameters&);

}  // namespace sigmasweep
