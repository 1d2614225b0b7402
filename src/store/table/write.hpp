#pragma once

#include <hdf5.h>  // brings MPI_Comm with the parallel library

#include <cstdint>
#include <span>
#include <string>

#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/row.hpp"
#include "store/table/packed_rows.hpp"
#include "store/table/table_info.hpp"

namespace sigmasweep {

/// Writes the table collectively: every rank of `comm` brings its contiguous block of rows, `first` being the place in
/// the table of the block's first row (blocks may be empty; together they make up `total_rows` rows, in spec order; of
/// a slice those that it has); `info` is rank 0's, but for the slice. /results holds `columns` in that order, /timings
/// the timing fields: one-dimensional compounds without padding, enumerations with their names. The unit and meaning of
/// member X are the dataset's attributes unit:X and meaning:X; its attribute checksum is the sum, modulo 2^64, of
/// XXH3_64bits of each row's bytes, seeded with the row's place in the table, and of the text that describes the
/// members (src/store/table/checksum.hpp).
///
/// Goes to PATH.part, space set aside up front, read back and compared by checksum, sealed with a checksum of the whole
/// file behind its end, synced, then renamed: PATH is complete or as it was before. Every rank returns or every rank
/// throws the same error (OutputError: cannot be created; IoError: disk full, a failed write, other bytes read back
/// than written). /results is the same to the bit for any number of ranks and any blocks.
void write_table(MPI_Comm comm, const std::string& path, const TableInfo& info, std::span<const Field> columns,
                 std::uint64_t total_rows, const BlockInPieces& block);
/// The same with rows that are not packed.
void write_table(MPI_Comm comm, const std::string& path, const TableInfo& info, std::span<const Field> columns,
                 std::uint64_t total_rows, std::uint64_t first, std::span<const Row> block);

}  // namespace sigmasweep
