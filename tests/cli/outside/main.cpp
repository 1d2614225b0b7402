#include <cmath>
#include <cstdio>
#include <sigmasweep/solve/simulate.hpp>
#include <sigmasweep/sweep/sweep.hpp>

int main() {
  const auto sweep =
      sigmasweep::Sweep::parse("[sweep]\nv0 = 1\ntc = 2e-5\nsigma = [0, 10]\nN = 10\nepsilon = 0.9\n", "a string");
  const double touching = sigmasweep::simulate(sweep.at(0)).eps_eff;
  const double apart = sigmasweep::simulate(sweep.at(1)).eps_eff;
  std::printf("%.12f %.12f\n", touching, apart);
  // Independent high-precision integrations of the same columns gave these digits.
  const bool right = std::abs(touching - 0.966686739758) < 1e-11 && std::abs(apart - 0.341547467017) < 1e-11;
  return right ? 0 : 1;
}
