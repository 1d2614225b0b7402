#pragma once

#include <array>
#include <string_view>

#include "sigmasweep/model/parameters.hpp"

/// The table of contact laws F = K x^(1+beta) + D x^gamma x'; Eqs. (2), (3), (8) and Sec. IV B.
namespace sigmasweep {

/// Exponents of spring and dashpot.
struct Exponents {
  double beta = 0.0, gamma = 0.0;
  bool linear() const { return beta == 0.0 && gamma == 0.0; }
};

/// A row of the table. A law with given exponents is a row here and an enumerator of Law, nothing else.
struct LawInfo {
  Law id;
  std::string_view name;  ///< as users write it
  Exponents exponents;
  bool free_exponents;       ///< beta and gamma are parameters of the tuple
  std::string_view meaning;  ///< source of the law
};

/// All laws, in the order of Law.
inline constexpr std::array laws{
    LawInfo{Law::hooke, "hooke", {0.0, 0.0}, false, "linear spring and dashpot, Eqs. (2), (3)"},
    LawInfo{Law::hertz, "hertz", {0.5, 0.0}, false, "elastic spheres with a linear dashpot, Refs. [28, 29, 44]"},
    LawInfo{Law::hertz_kuwabara_kono, "hertz-kuwabara-kono", {0.5, 0.5}, false, "viscoelastic spheres, Ref. [43]"},
    LawInfo{Law::taguchi, "taguchi", {0.5, 0.25}, false, "restitution that does not depend on the speed, Ref. [45]"},
    LawInfo{Law::power, "power", {0.0, 0.0}, true, "any exponents beta and gamma, Eq. (8)"},
    LawInfo{Law::cone, "cone", {1.0, 1.0}, false, "viscoelastic cones, Sneddon, Int. J. Eng. Sci. 3, 47 (1965)"},
};
static_assert(laws.size() == static_cast<std::size_t>(Law::cone) + 1);
constexpr auto enumerator_names(Law) { return names_in(laws); }

/// Exponents of the parameters' law.
constexpr Exponents exponents(const Parameters& p) {
  const LawInfo& law = laws[static_cast<std::size_t>(p.law)];
  return law.free_exponents ? Exponents{p.beta, p.gamma} : law.exponents;
}

}  // namespace sigmasweep
