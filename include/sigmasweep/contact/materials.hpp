#pragma once

#include "sigmasweep/model/parameters.hpp"

/// The materials of Sec. III.
namespace sigmasweep {

/// What a table of materials has.
struct Bead {
  double d;        ///< diameter, m
  double mass;     ///< kg
  double young;    ///< Young modulus Y, N/m^2
  double poisson;  ///< Poisson ratio
  double epsilon;  ///< restitution at 1 m/s
};
/// Steel and aluminium of Sec. III.
const Bead& bead(Material material);
/// E = Y/(3 (1 - Poisson^2)), Sec. III B.
double elastic_constant(const Bead& bead);

}  // namespace sigmasweep
