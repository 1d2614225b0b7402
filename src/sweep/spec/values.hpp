#pragma once

#include <vector>

#include "sweep/grid.hpp"
#include "sweep/spec/check.hpp"

/// Checks of what the values of several settings mean together. All throw SpecError.
namespace sigmasweep::spec {

/// Diameters are positive: width is not above 1.9 d anywhere.
void require_diameters(const std::vector<Setting>& settings, const std::vector<Zip>& zips, const Parameters& base);

/// rows x columns are not too many beads anywhere.
void require_lattice(const std::vector<Setting>& settings, const std::vector<Zip>& zips, const Parameters& base);

/// The plate of what vibrates: alpha and A0 are allowed for all frequencies and gravities that the axes span, and
/// the transient ends before the periods do.
void require_plate(const std::vector<Setting>& settings, const std::vector<Zip>& zips, const Parameters& base);

/// Where tc is given: s0 and sigma are both finite for all v0, tc that the axes span.
void require_finite_gap(const std::vector<Setting>& settings, const Parameters& base);

/// Where tc follows from the stiffness: every pair comes apart again, and s0 and sigma are finite. Up to about 10^4
/// pairs (10^5 for the linear law) all are looked at; of more than that the extremes of each axis, and what is wrong
/// in between is left to the row.
void require_pairs(const std::vector<Setting>& settings, const ParameterGrid& product);

}  // namespace sigmasweep::spec
