#pragma once

#include <vector>

#include "studies/precision/subject.hpp"

/// What the integrators of a precision study are compared with.
namespace sigmasweep {

/// The better one of the two references, and how well the other one agrees.
struct References {
  std::vector<ReferenceValue> answers;  ///< of the first tuples, as many as there was time for
  std::vector<bool> agreed;             ///< both were computed, and agree
  std::uint64_t checks = 0, chaotic = 0;
  double noise = PrecisionRow::nan;  ///< largest difference of the values where they agree
  /// Whether tuple k can be compared with its answer.
  bool usable(std::size_t k) const { return k < answers.size() && answers[k].known && (chaotic == 0 || agreed[k]); }
  /// Whether more of them would be of use, of which the first `max_checks` have both.
  bool worth_going_on(std::uint64_t max_checks) const;
};

References find_references(const PrecisionCase& subject, const PrecisionSpec& spec);

}  // namespace sigmasweep
