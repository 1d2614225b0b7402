#include "assembly/springs.hpp"

#include <cmath>

#include "sigmasweep/contact/calibration.hpp"
#include "sigmasweep/contact/pair_collision.hpp"
#include "sigmasweep/contact/theory.hpp"
#include "sigmasweep/model/law.hpp"

namespace sigmasweep {

/// Per reduced mass x'' + b x^gamma x' + k x^(1+beta) = 0, with K_over_m = k and D_n = b/2. Linear law: k = omega0^2
/// and b = 2 mu, Eqs. (5)-(7). Other laws: k by (A2), and the b of the restitution at v0 in units of v0 and tc, where a
/// length is v0 tc.
Parameters with_springs(Parameters p) {
  if (p.method != Method::md || p.K_over_m > 0.0 || !(p.epsilon > 0.0)) return p;
  const Exponents e = exponents(p);
  if (e.linear()) {
    const Oscillator<double> pair = oscillator(p.tc, p.epsilon);
    p.K_over_m = pair.omega0_2;
    p.D_n = pair.mu;
    return p;
  }
  const double b = damping(e, theory::stiffness(e, 1.0, 1.0), 1.0, p.epsilon);
  p.K_over_m = theory::stiffness(e, p.tc, p.v0);
  p.D_n = b / 2.0 / (p.tc * std::pow(p.v0 * p.tc, e.gamma));
  return p;
}

}  // namespace sigmasweep
