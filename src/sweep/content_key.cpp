#include "sigmasweep/sweep/content_key.hpp"

#include <array>
#include <bit>
#include <cstddef>

#include <xxhash.h>

#include "sigmasweep/model/exact_number.hpp"
#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/physics_version.hpp"

namespace sigmasweep {

namespace {

/// The bits of a number as a double: -0.0 is the 0.0 that it equals. What a double lacks of a whole number beyond 2^53
/// is added.
std::uint64_t word_of(AnyNumber value) {
  const auto rounded = static_cast<double>(value);
  const auto rest = static_cast<std::int64_t>(value - static_cast<AnyNumber>(rounded));
  return std::bit_cast<std::uint64_t>(rounded + 0.0) + static_cast<std::uint64_t>(rest);
}

}  // namespace

std::uint64_t content_key(const Parameters& parameters) {
  // All parameters in the order of the registry, without padding bytes.
  constexpr std::size_t max_fields = 64;
  std::array<std::uint64_t, max_fields> words{physics_version};
  std::size_t used = 1;
  for (const ParameterField& field : fields_of_parameters())
    words.at(used++) = word_of(exact_number(field, parameters));
  return XXH3_64bits(words.data(), used * sizeof words[0]);
}

}  // namespace sigmasweep
