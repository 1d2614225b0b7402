#include "sigmasweep/contact/calibration.hpp"

#include <cmath>
#include <limits>

#include <boost/math/constants/constants.hpp>

#include "base/quad.hpp"

namespace sigmasweep {
namespace {

template <class Real>
Real pi() {
  return boost::math::constants::pi<Real>();
}

/// L = -ln eps; fabs, so that eps = 1 gives +0.
template <class Real>
Real log_loss(const Real& eps) {
  using std::fabs, std::log;
  return fabs(log(eps));
}

}  // namespace

template <class Real>
Oscillator<Real> oscillator(Real tc, Real eps) {
  const Real mu = log_loss(eps) / tc;
  const Real omega = pi<Real>() / tc;
  return {mu, omega * omega + mu * mu};
}

template <class Real>
Real contact_time(const Oscillator<Real>& pair) {
  using std::sqrt;
  const Real omega_2 = pair.omega0_2 - pair.mu * pair.mu;
  if (!(omega_2 > 0)) return std::numeric_limits<Real>::quiet_NaN();
  return pi<Real>() / sqrt(omega_2);
}

template <class Real>
Real restitution(const Oscillator<Real>& pair) {
  using std::exp;
  return exp(-pair.mu * contact_time(pair));
}

template <class Real>
Oscillator<Real> wall_of(const Oscillator<Real>& pair) {
  return {pair.mu / 2, pair.omega0_2 / 2};
}

template <class Real>
Real wall_restitution(Real eps) {
  using std::exp, std::sqrt;
  const Real L = log_loss(eps);
  return exp(-pi<Real>() * L / sqrt(2 * pi<Real>() * pi<Real>() + L * L));
}

#define SIGMASWEEP_CALIBRATION(Real)                          \
  template Oscillator<Real> oscillator(Real, Real);           \
  template Real contact_time(const Oscillator<Real>&);        \
  template Real restitution(const Oscillator<Real>&);         \
  template Oscillator<Real> wall_of(const Oscillator<Real>&); \
  template Real wall_restitution(Real);
SIGMASWEEP_CALIBRATION(double)
SIGMASWEEP_CALIBRATION(long double)
SIGMASWEEP_CALIBRATION(Quad)
#undef SIGMASWEEP_CALIBRATION

}  // namespace sigmasweep
