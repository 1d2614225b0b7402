#include "contact/contact_law.hpp"

namespace sigmasweep {

int clock_exponent(const Exponents& e) {
  const auto whole = [](double x) { return std::fabs(x - std::round(x)) < 1e-9; };
  for (int q = 1; q <= 8; ++q)
    if (whole(q * e.beta) && whole(q * e.gamma)) return q;
  return 8;
}

}  // namespace sigmasweep
