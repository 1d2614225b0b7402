#pragma once

#include <cstdint>

#include "assembly/column.hpp"
#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "solve/outcome.hpp"

/// Columns of soft spheres as tests want them.
namespace sigmasweep {

inline Parameters soft_column(std::int64_t N, double epsilon, double sigma) {
  Parameters p;
  p.N = N;
  p.epsilon = epsilon;
  p.sigma = sigma;
  return complete(p, GapParameter::sigma);
}

template <class Real>
double eps_eff(const Column<Real>& column, const Outcome<Real>& outcome) {
  return static_cast<double>(energies<Real>(outcome.velocity, column.speed, column.mass).eps_eff);
}

}  // namespace sigmasweep
