#include "engine/ledger/identity.hpp"

#include <algorithm>
#include <cstdint>

#include "base/random.hpp"
#include "sigmasweep/model/physics_version.hpp"

namespace sigmasweep {

std::vector<Field> journalled_results(const Sweep& sweep) {
  std::vector<Field> results;
  for (const Field& column : sweep.columns())
    if (std::ranges::find(result_fields(), column.name, &Field::name) != result_fields().end())
      results.push_back(column);
  return results;
}

JournalIdentity journal_identity(const Sweep& sweep, const Slice& slice, std::span<const Field> results) {
  const std::uint64_t hash =
      slice.is_whole() ? sweep.hash() : random_bits(sweep.hash() ^ random_bits(slice.count, slice.index), 0);
  return {hash, physics_version, sweep.size(), results};
}

}  // namespace sigmasweep
