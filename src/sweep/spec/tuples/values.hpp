#pragma once

#include <vector>

#include "sweep/grid.hpp"
#include "sweep/spec/tuples/check.hpp"

/// Checks of the values of several settings together. All throw SpecError.
namespace sigmasweep::spec {

/// Requires positive diameters: width is at most 1.9 d for all tuples.
void require_diameters(const std::vector<Setting>& settings, const std::vector<Zip>& zips, const Parameters& base);

/// Requires an allowed number of beads, rows x columns, for all tuples.
void require_lattice(const std::vector<Setting>& settings, const std::vector<Zip>& zips, const Parameters& base);

/// Requires allowed values of alpha and A0 for all frequencies and gravities of the axes, and a transient that is
/// shorter than the periods.
void require_plate(const std::vector<Setting>& settings, const std::vector<Zip>& zips, const Parameters& base);

/// Requires finite s0 and sigma for all v0 and tc of the axes, and of lattices such that positions keep their digits.
/// Nothing is required if tc follows from the stiffness.
void require_finite_gap(const std::vector<Setting>& settings, const Parameters& base, bool of_lattice);

/// Requires that every pair separates after its collision, with finite s0 and sigma, if tc follows from the stiffness.
/// Up to about 10^4 pairs (10^5 for the linear law) are all checked. Of more pairs the extremes of each axis are
/// checked; a bad pair between them becomes a failed row.
void require_pairs(const std::vector<Setting>& settings, const ParameterGrid& product);

}  // namespace sigmasweep::spec
