#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

#include "sigmasweep/contact/pair_collision.hpp"
#include "sigmasweep/contact/theory.hpp"
#include "sigmasweep/model/law.hpp"

namespace sigmasweep {

/// Collisions of pairs under a law that is not linear, by interpolation. In units of the largest overlap l without
/// losses and of the speed v, x'' + b x^gamma x' + k x^(1+beta) = 0 has one parameter beside the exponents,
///     b' = b l^(1+gamma)/v,
/// and restitution, duration over l/v and largest overlap over l are smooth functions of it. They are Chebyshev
/// polynomials up to b' = 0.6, where restitutions are still above a fourth. Relative errors are below `accuracy`.
class CollisionTable {
 public:
  static constexpr double accuracy = 3e-14;

  /// The table of these exponents, computed at the first call (in about two milliseconds). None where their functions
  /// are not smooth enough. Tables belong to a thread.
  static std::shared_ptr<const CollisionTable> of(Exponents exponents);

  /// As sigmasweep::collide(). None beyond the table.
  std::optional<PairCollision> collide(const PairLaw& law, double v) const;

 private:
  static constexpr std::size_t terms = 24;
  static constexpr double largest = 0.6;
  using Series = std::array<double, terms>;

  explicit CollisionTable(Exponents exponents);
  bool has_converged() const;

  Series restitution_, duration_, x_max_;
};

}  // namespace sigmasweep
