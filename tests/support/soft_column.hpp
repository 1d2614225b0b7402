#pragma once

#include "assembly/column.hpp"
#include "assembly/energies.hpp"
#include "solve/outcome.hpp"
#include "support/parameters.hpp"

/// Results of columns of soft spheres as tests want them.
namespace sigmasweep {

template <class Real>
double eps_eff(const Column<Real>& column, const Outcome<Real>& outcome) {
  return static_cast<double>(energies<Real>(outcome.velocity, column.speed, column.mass).eps_eff);
}

}  // namespace sigmasweep
