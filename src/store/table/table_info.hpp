#pragma once

#include <cstdint>
#include <string>

#include "sweep/slice.hpp"

namespace sigmasweep {

/// What a table's root attributes say about the sweep and its run: title, spec, spec_hash (hexadecimal text), host,
/// start, ranks, and for a slice of a sweep slice_index and slice_count. The writer adds format ("sigmasweep-table"),
/// format_version, rows, physics_version, program_version, git_revision, compiler, compiler_flags, mpi_version and
/// hdf5_version. All texts are UTF-8. The journal of the sweep holds the same while it runs.
struct TableInfo {
  std::string title, spec_text, host, start;  ///< start: ISO 8601, UTC
  std::uint64_t spec_hash = 0;
  int ranks = 1;
  Slice slice;                        ///< the table's rows are those; every rank has the same
  std::uint32_t physics_version = 0;  ///< of a table that was read; the writer writes the program's own
  std::string build;                  ///< likewise, as build_name()
};

}  // namespace sigmasweep
