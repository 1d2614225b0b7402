#include "sigmasweep/contact/theory.hpp"

#include <cmath>

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>

namespace sigmasweep {
namespace theory {

double I(double beta) {
  const double n = 2.0 + beta;
  return boost::math::constants::root_pi<double>() * boost::math::tgamma(1.0 / n) /
         (0.5 * n * boost::math::tgamma((4.0 + beta) / (2.0 * n)));
}

double largest_overlap(const PairLaw& law, double v) {
  const double n = 2.0 + law.exponents.beta;
  return std::pow(0.5 * n * v * v / law.k, 1.0 / n);
}

double contact_time(const PairLaw& law, double v) { return I(law.exponents.beta) * largest_overlap(law, v) / v; }

double stiffness(Exponents exponents, double tc, double v) {
  const double n = 2.0 + exponents.beta;
  return 0.5 * n * v * v / std::pow(v * tc / I(exponents.beta), n);
}

double loss(const PairLaw& law, double v) {
  const auto [beta, gamma] = law.exponents;
  const double n = 2.0 + beta, p = (1.0 + gamma) / n;
  return law.b * std::pow(0.5 * n / law.k, p) * (2.0 / n) * boost::math::beta(p, 1.5) *
         std::pow(v, (2.0 * gamma - beta) / n);
}

Powers powers(Exponents exponents) {
  const double n = 2.0 + exponents.beta;
  return {2.0 / n, -exponents.beta / n, (2.0 * exponents.gamma - exponents.beta) / n};
}

}  // namespace theory
}  // namespace sigmasweep
