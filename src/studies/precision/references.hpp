#pragma once

#include <vector>

#include "studies/precision/cases/precision_case.hpp"

/// The references with which a precision study compares the integrators.
namespace sigmasweep {

/// The references of a case: for each tuple the better one of two, and its agreement with the other one.
struct References {
  std::vector<ReferenceValue> values;  ///< of the first tuples, as many as could be computed in time
  std::vector<bool> agreed;            ///< both references were computed, and agree
  std::uint64_t checks = 0, chaotic = 0;
  double noise = PrecisionRow::nan;  ///< largest difference of two references that agree
  /// Whether tuple k can be compared with its reference.
  bool usable(std::size_t k) const { return k < values.size() && values[k].known && (chaotic == 0 || agreed[k]); }
  /// Whether references of further tuples would be of use. The first `max_checks` tuples have both.
  bool worth_going_on(std::uint64_t max_checks) const;
};

References find_references(const PrecisionCase& scene, const PrecisionSpec& spec);

}  // namespace sigmasweep
