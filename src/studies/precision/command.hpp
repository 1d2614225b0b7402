#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mpi/world.hpp"

namespace sigmasweep {

/// The options of the command `precision`.
struct PrecisionOptions {
  std::string spec;                              ///< path of a sweep spec with a table [precision]
  std::vector<std::string> settings{};           ///< "KEY=VALUE": keys of [sweep] that are replaced
  std::string output;                            ///< path of the table; empty: default_table(spec)
  std::optional<std::uint64_t> tuples, repeats;  ///< replace the spec's
  bool quiet = false, plots = true;
};

/// Measures all scenes of the spec, prints and writes the study's table and draws its pictures; on all ranks. Returns
/// the exit code, as run() does.
int precision_study(World& world, const PrecisionOptions& options);

}  // namespace sigmasweep
