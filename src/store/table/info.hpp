#pragma once

#include <hdf5.h>

#include <cstdint>

#include "mpi/rank_group.hpp"
#include "store/table/table_info.hpp"

/// The root attributes of a table.
namespace sigmasweep {

/// Rank 0's info, on every rank: HDF5 wants collective metadata to be the same everywhere. Collective.
TableInfo common_info(const RankGroup& group, TableInfo info);

/// Writes the root attributes. Collective, with the common_info(); or for a file of one rank. Texts that are too long
/// for an attribute are datasets (long_text.hpp), and still empty.
void write_info(hid_t file, const char* format, std::uint64_t format_version, const TableInfo& info,
                std::uint64_t rows);
/// Fills these datasets. On one rank.
void write_long_texts(hid_t file, const TableInfo& info);

struct StoredInfo {
  TableInfo info;
  std::uint64_t rows = 0;
};

/// Reads the root attributes. Throws IoError for a file that is no table, or of a format that this program does not
/// know.
StoredInfo read_info(hid_t file);

}  // namespace sigmasweep
