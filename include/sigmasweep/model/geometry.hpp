#pragma once

#include "sigmasweep/model/parameters.hpp"

namespace sigmasweep {

constexpr bool is_vibrated(const Parameters& p) {
  return p.geometry == Geometry::vibrated_column || p.geometry == Geometry::vibrated_lattice;
}
/// Whether it has two dimensions.
constexpr bool is_lattice(const Parameters& p) {
  return p.geometry == Geometry::lattice || p.geometry == Geometry::vibrated_lattice;
}

/// A step of complete(), for what vibrates: alpha = A0 (2 pi f)^2/g and A0, the missing one from the other. Where
/// both are there and differ A0 counts. What is complete already stays as it is, to the bit.
void derive_plate_motion(Parameters& parameters);

/// A0 sin(2 pi f t), Eq. (1), m; t in s. Of complete parameters.
double plate_height(const Parameters& parameters, double t);
/// The plate's speed then, m/s.
double plate_speed(const Parameters& parameters, double t);

}  // namespace sigmasweep
