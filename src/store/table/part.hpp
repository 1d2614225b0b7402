#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mpi/rank_group.hpp"
#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/row.hpp"
#include "store/table/packed_rows.hpp"
#include "store/table/table_info.hpp"

/// The steps of write_table(): all ranks write PATH.part, then read it back.
namespace sigmasweep {

/// One dataset of a table.
struct Section {
  std::string name;
  std::span<const Field> fields;
};

/// The checksums of a dataset.
struct Checksums {
  std::uint64_t block = 0;    ///< of a block of its rows
  std::uint64_t dataset = 0;  ///< of all rows and of the layout; the file has it as an attribute (checksum.hpp)
  bool operator==(const Checksums&) const = default;
};

/// Sets aside disk space for the file's first `bytes` bytes. Throws IoError (disk full).
void reserve_space(const std::string& path, std::uint64_t bytes);

/// Collective. Makes the file `path`, which must be there already, a table of `total_rows` rows with these datasets
/// and this rank's block in them, piece after piece. Returns the checksums of each dataset, with those of this rank's
/// block.
std::vector<Checksums> write_part(const RankGroup& group, const std::string& path, const TableInfo& info,
                                  std::span<const Section> sections, std::uint64_t total_rows,
                                  const BlockInPieces& block);

/// Reads the table that write_part() wrote, on this rank alone. Returns the checksums of each dataset, with those of
/// this range of rows. Throws IoError if the file is anything else.
std::vector<Checksums> checksums_in_part(const std::string& path, std::span<const Section> sections,
                                         std::uint64_t total_rows, std::uint64_t first, std::uint64_t rows);

}  // namespace sigmasweep
