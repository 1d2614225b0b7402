#pragma once

#include "sigmasweep/model/parameters.hpp"

/// Contact laws F = K x^(1+beta) + D x^gamma x' and their theory for weak dissipation (Sec. IV B and the Appendix).
namespace sigmasweep {

struct Exponents {
  double beta = 0.0, gamma = 0.0;
  bool linear() const { return beta == 0.0 && gamma == 0.0; }
};

/// Of the parameters' law.
Exponents exponents(const Parameters& parameters);

/// A pair of beads, or a bead at a wall, per reduced mass: x'' + b x^gamma x' + k x^(1+beta) = 0. Any consistent units.
struct PairLaw {
  Exponents exponents;
  double k = 0.0, b = 0.0;
};

/// The paper's formulas for the contact of such a pair that meets at speed v, all without dissipation or to first
/// order in it.
namespace theory {

/// I(beta) = sqrt(pi) Gamma(1/(2+beta)) / ((1+beta/2) Gamma((4+beta)/(4+2 beta))): pi for Hooke, 2.94 for Hertz.
double I(double beta);
/// (A1): x_max = ((1+beta/2) v^2/k)^(1/(2+beta)).
double largest_overlap(const PairLaw& law, double v);
/// (A2): tc = I(beta) x_max/v.
double contact_time(const PairLaw& law, double v);
/// The k that gives a contact time tc at v by (A2).
double stiffness(Exponents exponents, double tc, double v);
/// (A4) with its prefactor, p = (1+gamma)/(2+beta):
///     1 - eps = (b/k^p) (1+beta/2)^p 2/(2+beta) B(p, 3/2) v^((2 gamma - beta)/(2+beta)).
double loss(const PairLaw& law, double v);

/// Exponents of v in x_max, tc and 1 - eps: Table I.
struct Powers {
  double nu1, nu2, nu3;
};
Powers powers(Exponents exponents);

}  // namespace theory

/// How a pair comes apart again, from the equation of motion itself. Errors of eps below 1e-13.
struct PairCollision {
  double eps = 0.0;       ///< restitution; 0 if it never comes apart
  double duration = 0.0;  ///< contact time; infinite if it never comes apart
  double x_max = 0.0;     ///< largest overlap
};
PairCollision collide(const PairLaw& law, double v);

/// The b for which a pair that meets at v has restitution eps, for the k given. 0 < eps <= 1. NaN if there is none.
double damping(Exponents exponents, double k, double v, double eps);

/// What a table of materials has.
struct Bead {
  double d;        ///< diameter, m
  double mass;     ///< kg
  double young;    ///< Young modulus Y, N/m^2
  double poisson;  ///< Poisson ratio
  double epsilon;  ///< restitution at 1 m/s
};
/// Steel and aluminium of Sec. III.
const Bead& bead(Material material);
/// E = Y/(3 (1 - Poisson^2)), Sec. III B.
double elastic_constant(const Bead& bead);

}  // namespace sigmasweep
