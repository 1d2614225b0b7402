#include "assembly/plate_motion.hpp"

#include <cmath>
#include <numbers>

namespace sigmasweep {
namespace {

/// Of the plate. In periods first, of which the whole ones do not count: as exact after many of them.
double phase(const Parameters& p, double t) {
  const double turns = p.frequency * t;
  return 2.0 * std::numbers::pi * (turns - std::floor(turns));
}

}  // namespace

double plate_height(const Parameters& p, double t) { return p.A0 * std::sin(phase(p, t)); }
double plate_speed(const Parameters& p, double t) {
  return p.A0 * 2.0 * std::numbers::pi * p.frequency * std::cos(phase(p, t));
}

}  // namespace sigmasweep
