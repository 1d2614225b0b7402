#pragma once

#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/model/parameters.hpp"

/// Complete parameters as tests want them, from those that matter: soft_column({.sigma = 2, .epsilon = 0.9, .N = 10}).
/// The gap is sigma where that is given, else s0.
namespace sigmasweep {

inline Parameters completed(const Parameters& given) {
  return complete(given, given.sigma > 0.0 ? GapParameter::sigma : GapParameter::s0);
}

inline Parameters soft_column(const Parameters& given) { return completed(given); }

inline Parameters soft_column(std::int64_t N, double epsilon, double sigma) {
  return soft_column({.sigma = sigma, .epsilon = epsilon, .N = N});
}

inline Parameters hard_column(Parameters given) {
  given.method = Method::ed;
  return completed(given);
}

inline Parameters vibrated_column(Parameters given) {
  given.geometry = Geometry::vibrated_column;
  return completed(given);
}

inline Parameters lattice(Parameters given) {
  given.geometry = Geometry::lattice;
  return completed(given);
}

inline Parameters vibrated_lattice(Parameters given) {
  given.geometry = Geometry::vibrated_lattice;
  return completed(given);
}

}  // namespace sigmasweep
