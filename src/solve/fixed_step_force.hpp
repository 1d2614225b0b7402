#pragma once

#include <cmath>

#include "sigmasweep/scene/law.hpp"

/// The laws F = K x^(1+beta) + C x^gamma x' where x > 0, else 0, as the fixed-step schemes compute them: once a contact
/// and stage, without branches, so that the loops over contacts vectorise. `elastic` is twice the elastic energy,
/// 2 K x^(2+beta)/(2+beta), of an overlap x > 0.
namespace sigmasweep::fixed_step {

struct LinearForce {
  explicit LinearForce(const Exponents&) {}
  double operator()(double K, double C, double x, double u) const { return x > 0.0 ? K * x + C * u : 0.0; }
  double elastic(double K, double x) const { return K * x * x; }
};

/// beta = 1/2 and gamma = QuarterGammas/4: Hertz 0, Taguchi 1, Hertz-Kuwabara-Kono 2.
template <int QuarterGammas>
struct HertzForce {
  static_assert(QuarterGammas >= 0 && QuarterGammas <= 2);
  explicit HertzForce(const Exponents&) {}
  double operator()(double K, double C, double x, double u) const {
    const double y = x > 0.0 ? x : 0.0, root = std::sqrt(y);
    double damping = C * u;
    if constexpr (QuarterGammas == 1) damping *= std::sqrt(root);
    if constexpr (QuarterGammas == 2) damping *= root;
    return x > 0.0 ? K * y * root + damping : 0.0;
  }
  double elastic(double K, double x) const { return 0.8 * K * x * x * std::sqrt(x); }
};

struct PowerForce {
  explicit PowerForce(const Exponents& e) : beta(e.beta), gamma(e.gamma) {}
  double operator()(double K, double C, double x, double u) const {
    return x > 0.0 ? K * std::pow(x, 1.0 + beta) + C * std::pow(x, gamma) * u : 0.0;
  }
  double elastic(double K, double x) const { return 2.0 * K * std::pow(x, 2.0 + beta) / (2.0 + beta); }
  double beta, gamma;
};

}  // namespace sigmasweep::fixed_step
