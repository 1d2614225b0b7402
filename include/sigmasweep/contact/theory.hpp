#pragma once

#include "sigmasweep/model/law.hpp"

/// Theory of a single contact for weak dissipation (Sec. IV B and the Appendix).
namespace sigmasweep {

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

}  // namespace sigmasweep
