#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "sigmasweep/sweep/fields.hpp"
#include "sigmasweep/sweep/precision.hpp"

namespace sigmasweep {

/// What a precision study's root attributes say beside the program's versions.
struct PrecisionInfo {
  std::string title, spec_text, host, start;  ///< start: ISO 8601, UTC
  std::uint64_t spec_hash = 0;
  int ranks = 1;
};

/// Writes a precision study: a compound dataset /precision, one row for each scene and setting, with these parameters,
/// the integrator and precision_fields(); units and meanings as its attributes unit:X and meaning:X. Made in memory,
/// written to PATH.part, synced, renamed: PATH is complete or as it was before. Throws OutputError or IoError.
void write_precision_table(const std::string& path, const PrecisionInfo& info, std::span<const Field> parameters,
                           std::span<const PrecisionRow> rows);

}  // namespace sigmasweep
