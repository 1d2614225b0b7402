#pragma once

#include "sigmasweep/model/parameters.hpp"

namespace sigmasweep {

/// A0 sin(2 pi f t), Eq. (1), m; t in s. Of complete parameters.
double plate_height(const Parameters& parameters, double t);
/// The plate's speed then, m/s.
double plate_speed(const Parameters& parameters, double t);

}  // namespace sigmasweep
