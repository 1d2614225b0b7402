#pragma once

#include <optional>
#include <vector>

#include "sweep/expression/where.hpp"
#include "sweep/spec/tuples/axis.hpp"
#include "sweep/spec/tuples/check.hpp"

namespace sigmasweep::spec {

/// What a table [sweep] has, each key read by itself.
struct SweepKeys {
  std::vector<Setting> settings;  ///< in spec order, keys of [defaults] first
  std::vector<Zip> zips;
  std::optional<Entry> zip, where;
};

/// Reads the keys of [sweep], and those of [defaults] that it does not have itself. Throws SpecError with all mistakes.
SweepKeys read_contents(const Entry& sweep, const std::vector<Entry>& defaults);
/// Whether a key stands in [defaults].
bool is_default(const Entry& key);
/// The condition `where`. Throws SpecError.
ParameterWhere condition_of(const Entry& entry);
/// The keys of [sweep] that are not parameters.
std::vector<KeyInfo> keys_of_sweep();

}  // namespace sigmasweep::spec
