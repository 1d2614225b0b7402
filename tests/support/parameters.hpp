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

/// A lattice of discs whose diameter is given in units of v0 tc: how far it exceeds overlaps, and so how much a
/// direction changes meanwhile.
inline Parameters lattice_of_discs(std::int64_t rows, std::int64_t columns, double epsilon, double sigma,
                                   double d = 1000.0) {
  constexpr double v0 = 0.05, tc = 2e-5;
  return lattice(
      {.v0 = v0, .tc = tc, .sigma = sigma, .epsilon = epsilon, .d = d * v0 * tc, .rows = rows, .columns = columns});
}

inline Parameters vibrated_lattice(Parameters given) {
  given.geometry = Geometry::vibrated_lattice;
  return completed(given);
}

}  // namespace sigmasweep
