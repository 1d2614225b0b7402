#pragma once

#include <boost/multiprecision/float128.hpp>

namespace sigmasweep {

/// The wide type of the numerics, for checks and references: 113 bits, g++'s __float128 with libquadmath. Calibration,
/// columns and outcomes exist for double, long double and Quad; call maths functions unqualified (using std::sqrt).
using Quad = boost::multiprecision::float128;

}  // namespace sigmasweep
