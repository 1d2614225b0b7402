#include "sigmasweep/contact/law.hpp"

#include <array>
#include <cmath>

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>

namespace sigmasweep {

Exponents exponents(const Parameters& parameters) {
  switch (parameters.law) {
    case Law::hooke: return {0.0, 0.0};
    case Law::hertz: return {0.5, 0.0};
    case Law::hertz_kuwabara_kono: return {0.5, 0.5};
    case Law::taguchi: return {0.5, 0.25};
    case Law::power: break;
  }
  return {parameters.beta, parameters.gamma};
}

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

const Bead& bead(Material material) {
  // Sec. III B; epsilon as the paper uses it for these materials.
  static constexpr std::array<Bead, 3> beads{
      {{}, {1.5e-3, 1.38e-5, 2.06e11, 0.28, 0.9}, {1.5e-3, 0.479e-5, 0.71e11, 0.34, 0.6}}};
  return beads[static_cast<std::size_t>(material)];
}

double elastic_constant(const Bead& bead) { return bead.young / (3.0 * (1.0 - bead.poisson * bead.poisson)); }

}  // namespace sigmasweep
