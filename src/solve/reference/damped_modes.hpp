#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace sigmasweep {

/// The ends of a run of closed contacts in a column of equal beads of mass 1: both free, or the lowest contact the
/// wall's, with the spring of a pair (Wall::paper) or twice that (Wall::matched).
enum class RunKind { free, at_wall, at_matched_wall };

/// Shapes and eigenvalues of a run of c closed contacts, x'' = -A W (K x + C x'). W is 1 but for a matched wall's 2;
/// A has 2 on the diagonal, 1 at the wall, and -1 beside it. With x_m = sum_j shape(m, j) y_j the modes separate:
///     y_j'' + lambda_j (C y_j' + K y_j) = 0,  lambda_j = 2 - 2 cos theta_j.
struct DampedModes {
  std::vector<long double> lambda;
  std::vector<long double> shape;     ///< [m c + j]
  std::vector<long double> analysis;  ///< [m c + j]: y_j = sum_m analysis(m, j) x_m
  std::size_t size() const { return lambda.size(); }
};

/// All that was asked for, made once.
class ModeTables {
 public:
  const DampedModes& of(RunKind kind, std::size_t contacts);

 private:
  std::map<std::pair<RunKind, std::size_t>, DampedModes> tables_;
};

/// y'' + 2 mu y' + omega2 y = 0 over a time t: (y, v) -> (yy y + yv v, vy y + vv v).
struct Propagator {
  long double yy, yv, vy, vv;
};
/// For any damping: delta = omega2 - mu^2 > 0 under-, = 0 critically, < 0 over-damped; near 0 by the power series of
/// cos(sqrt z) and sin(sqrt z)/sqrt z, z = delta t^2, which is both at once.
Propagator propagator(long double mu, long double omega2, long double t);

}  // namespace sigmasweep
