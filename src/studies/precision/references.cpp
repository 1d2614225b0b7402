#include "studies/precision/references.hpp"

#include <cmath>
#include <utility>

#include "base/thread_clock.hpp"

namespace sigmasweep {
namespace {

/// Largest difference of two references that agree; a tuple with a larger one is chaotic.
constexpr double chaos = 1e-9;

}  // namespace

/// Among tuples that are chaotic only checked ones can be compared; where none of the first few is, none will be.
bool References::worth_going_on(std::uint64_t max_checks) const {
  constexpr std::uint64_t few = 3;
  return chaotic == 0 || (checks < max_checks && (chaotic < checks || checks < few));
}

References find_references(const PrecisionCase& scene, const PrecisionSpec& spec) {
  References found;
  const double start = thread_seconds();
  for (std::size_t k = 0; k < scene.tuples.size() && found.worth_going_on(spec.checks); ++k) {
    if (k > 0 && thread_seconds() - start > spec.seconds) break;
    ReferenceValue value = scene.reference(scene.tuples[k]);
    bool agree = false;
    if (k < spec.checks) {
      ReferenceValue other = scene.check(scene.tuples[k]);
      ++found.checks;
      const auto difference = static_cast<double>(std::fabs(other.value - value.value));
      agree = other.known && value.known && difference <= chaos;
      if (!agree)
        ++found.chaotic;
      else if (!(found.noise >= difference))
        found.noise = difference;
      if (agree && scene.check_is_better) value = std::move(other);
    }
    found.values.push_back(std::move(value));
    found.agreed.push_back(agree);
  }
  return found;
}

}  // namespace sigmasweep
