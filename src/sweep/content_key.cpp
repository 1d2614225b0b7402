#include <array>
#include <bit>
#include <cstddef>

#include <xxhash.h>

#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/physics_version.hpp"
#include "sigmasweep/sweep/sweep.hpp"

namespace sigmasweep {

std::uint64_t content_key(const Parameters& parameters) {
  // All parameters in the order of the registry, without padding bytes.
  constexpr std::size_t max_fields = 64;
  std::array<std::uint64_t, max_fields> words{physics_version};
  std::size_t used = 1;
  for (const ParameterField& field : fields_of_parameters())
    words.at(used++) =
        std::bit_cast<std::uint64_t>(number(field, parameters) + 0.0);  // + 0.0 makes -0.0 the 0.0 it equals
  return XXH3_64bits(words.data(), used * sizeof words[0]);
}

}  // namespace sigmasweep
