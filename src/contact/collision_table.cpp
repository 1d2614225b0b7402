#include "contact/collision_table.hpp"

#include <algorithm>
#include <boost/math/special_functions/chebyshev.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace sigmasweep {
namespace {

/// Of the polynomial through the values at Chebyshev's nodes cos(pi (i + 1/2)/n).
template <std::size_t n>
std::array<double, n> coefficients(const std::array<double, n>& values) {
  std::array<double, n> c;
  for (std::size_t j = 0; j < n; ++j) {
    long double sum = 0.0L;
    for (std::size_t i = 0; i < n; ++i)
      sum +=
          values[i] * std::cos(std::numbers::pi_v<long double> * static_cast<long double>(j * (2 * i + 1)) / (2 * n));
    c[j] = static_cast<double>(2.0L * sum / static_cast<long double>(n));
  }
  return c;
}

}  // namespace

CollisionTable::CollisionTable(Exponents exponents) {
  const double k = 0.5 * (2.0 + exponents.beta);  // l = 1 at v = 1
  Series restitution, duration, x_max;
  for (std::size_t i = 0; i < terms; ++i) {
    const double node = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(terms));
    const PairCollision c = sigmasweep::collide({exponents, k, 0.5 * largest * (1.0 + node)}, 1.0);
    restitution[i] = c.eps;
    duration[i] = c.duration;
    x_max[i] = c.x_max;
  }
  restitution_ = coefficients(restitution);
  duration_ = coefficients(duration);
  x_max_ = coefficients(x_max);
}

/// The last terms say what those left out would add. NaN where a pair never separates.
bool CollisionTable::has_converged() const {
  return std::ranges::all_of(std::array{restitution_, duration_, x_max_}, [](const Series& c) {
    const auto is_small = [&](double term) { return std::fabs(term) <= 0.5 * accuracy * std::fabs(c[0]); };
    return std::all_of(c.end() - 3, c.end(), is_small);
  });
}

std::shared_ptr<const CollisionTable> CollisionTable::of(Exponents exponents) {
  constexpr std::size_t most = 64;
  thread_local std::map<std::pair<double, double>, std::shared_ptr<const CollisionTable>> known;
  const std::pair key{exponents.beta, exponents.gamma};
  if (const auto found = known.find(key); found != known.end()) return found->second;
  if (known.size() >= most) known.clear();
  const std::shared_ptr<const CollisionTable> table(new CollisionTable(exponents));
  return known[key] = table->has_converged() ? table : nullptr;
}

std::optional<PairCollision> CollisionTable::collide(const PairLaw& law, double v) const {
  const double length = theory::largest_overlap(law, v), time = length / v;
  const double b = law.b * time * std::pow(length, law.exponents.gamma);
  if (!(b <= largest)) return std::nullopt;
  const double z = 2.0 * b / largest - 1.0;
  const auto at = [z](const Series& c) { return boost::math::chebyshev_clenshaw_recurrence(c.data(), c.size(), z); };
  return PairCollision{std::fmin(at(restitution_), 1.0), at(duration_) * time, at(x_max_) * length};
}

}  // namespace sigmasweep
