#include "studies/precision/references.hpp"

#include <cmath>
#include <utility>

#include "base/thread_clock.hpp"

namespace sigmasweep {
namespace {

/// References that differ by more than this are no references.
constexpr double chaos = 1e-9;

}  // namespace

/// Among tuples that are chaotic only checked ones can be compared; where none of the first few is, none will be.
bool References::worth_going_on(std::uint64_t max_checks) const {
  constexpr std::uint64_t few = 3;
  return chaotic == 0 || (checks < max_checks && (chaotic < checks || checks < few));
}

References find_references(const PrecisionCase& subject, const PrecisionSpec& spec) {
  References found;
  const double start = thread_seconds();
  for (std::size_t k = 0; k < subject.tuples.size() && found.worth_going_on(spec.checks); ++k) {
    if (k > 0 && thread_seconds() - start > spec.seconds) break;
    ReferenceValue answer = subject.reference(subject.tuples[k]);
    bool agree = false;
    if (k < spec.checks) {
      ReferenceValue other = subject.check(subject.tuples[k]);
      ++found.checks;
      const auto difference = static_cast<double>(std::fabs(other.value - answer.value));
      agree = other.known && answer.known && difference <= chaos;
      if (!agree)
        ++found.chaotic;
      else if (!(found.noise >= difference))
        found.noise = difference;
      if (agree && subject.check_is_better) answer = std::move(other);
    }
    found.answers.push_back(std::move(answer));
    found.agreed.push_back(agree);
  }
  return found;
}

}  // namespace sigmasweep
