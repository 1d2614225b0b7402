#pragma once

namespace sigmasweep {

/// Component and rate within steps just done, s from 0 to 1 on the way. For the component it is Hermite's cubic through
/// the values and rates at both ends; for the rate, which has a kink where a contact opens or closes, the straight
/// line.
struct BetweenSteps {
  double x, u;
  BetweenSteps(double s, double steps, double x0, double u0, double x1, double u1) {
    const double r = 1.0 - s;
    x = r * r * ((1.0 + 2.0 * s) * x0 + s * steps * u0) + s * s * ((1.0 + 2.0 * r) * x1 - r * steps * u1);
    u = r * u0 + s * u1;
  }
};

}  // namespace sigmasweep
