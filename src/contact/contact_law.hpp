#pragma once

#include <cmath>
#include <concepts>
#include <utility>

#include "contact/laws/hertz.hpp"
#include "contact/laws/linear.hpp"
#include "contact/laws/power.hpp"
#include "sigmasweep/model/law.hpp"

/// The forms of contact laws, F = K x^(1+beta) + C x^gamma u, x >= 0 the overlap and u = x' its rate (Sec. IV B). Each
/// form is a class in contact/laws and a place in the list below; the derivation is in docs/physics/contact-laws.md.
namespace sigmasweep {

/// What a form of a law gives the solvers. None of these functions has branches, so that loops over contacts vectorise.
/// - covers(exponents): whether the form holds for them.
/// - law(K, C, x, u): the force of a closed contact.
/// - twice_elastic_energy(K, x) = 2 K x^(2+beta)/(2+beta).
template <class Law>
concept ContactLaw = std::constructible_from<Law, const Exponents&> &&
    requires(const Law& law, const Exponents& e, const double& number) {
  { Law::covers(e) } -> std::same_as<bool>;
  { Law::costs_more_than_a_branch } -> std::convertible_to<bool>;
  { law(number, number, number, number) } -> std::same_as<double>;
  { law.twice_elastic_energy(number, number) } -> std::same_as<double>;
};

/// A list of forms; the first that covers the exponents is taken, the last one covers all.
template <ContactLaw... Laws>
struct LawList {};

/// All laws but the linear one. Solvers of these laws evaluate linear exponents by powers.
using NonlinearLaws = LawList<HertzLaw<0>, HertzLaw<1>, HertzLaw<2>, PowerLaw>;
using AllLaws = LawList<LinearLaw, HertzLaw<0>, HertzLaw<1>, HertzLaw<2>, PowerLaw>;

/// visitor(law) for the first form of the list that covers the exponents.
template <ContactLaw First, ContactLaw... Others, class Visitor>
decltype(auto) visit_law(LawList<First, Others...>, const Exponents& e, Visitor&& visitor) {
  if constexpr (sizeof...(Others) == 0) {
    return visitor(First(e));
  } else {
    if (First::covers(e)) return visitor(First(e));
    return visit_law(LawList<Others...>{}, e, std::forward<Visitor>(visitor));
  }
}
template <class Visitor>
decltype(auto) visit_law(const Exponents& e, Visitor&& visitor) {
  return visit_law(AllLaws{}, e, std::forward<Visitor>(visitor));
}

/// The force of a contact that may be open, x <= 0: none then.
template <class Law, class Real>
Real where_closed(const Law& law, const Real& K, const Real& C, const Real& x, const Real& u) {
  return x > Real(0) ? law(K, C, x > Real(0) ? x : Real(0), u) : Real(0);
}

/// Twice the elastic energy of a closed contact, 2 K x^(2+beta)/(2+beta), by powers where the law is not linear.
template <class Real>
Real twice_elastic_energy(const Exponents& e, const Real& K, const Real& x) {
  return e.linear() ? LinearLaw(e).twice_elastic_energy(K, x) : PowerLaw(e).twice_elastic_energy(K, x);
}
/// C x^(1+gamma)/(1+gamma): the momentum that the dashpot takes back on the way of a closed contact to x = 0.
template <class Real>
Real dashpot_potential(const Exponents& e, const Real& C, const Real& x) {
  return e.linear() ? LinearLaw(e).dashpot_potential(C, x) : PowerLaw(e).dashpot_potential(C, x);
}

/// Spring and dashpot of a small motion about an overlap: dF/dx for K = 1, C = 0, and dF/du for C = 1.
struct Tangent {
  double spring, dashpot;
};
inline Tangent tangent(const Exponents& e, double x) {
  return {(1.0 + e.beta) * std::pow(x, e.beta), std::pow(x, e.gamma)};
}

/// The clock exponent q: in s = x^(1/q) the force is smooth where a contact opens or closes. The smallest q for which
/// all powers of s in the law are whole; where there is none 8, smooth enough for a scheme of order 8.
int clock_exponent(const Exponents& e);

}  // namespace sigmasweep
