#include "store/table/part.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>

#include "base/file.hpp"
#include "model/packing.hpp"
#include "store/hdf5/attributes.hpp"
#include "store/hdf5/open.hpp"
#include "store/table/checksum.hpp"
#include "store/table/info.hpp"
#include "store/table/types.hpp"

namespace sigmasweep {
namespace {

/// Number of rows that are packed or read at a time. It bounds the memory, and keeps transfers far below MPI's 2 GiB.
std::uint64_t rows_per_transfer(const Section& section) {
  constexpr std::uint64_t bytes_per_transfer = std::uint64_t{32} << 20;
  return bytes_per_transfer / packed_size(section.fields);
}

Handle property_list(hid_t kind) { return {H5Pcreate(kind), H5Pclose, "cannot make a property list"}; }

Handle create_file(const RankGroup& group, const std::string& path) {
  const Handle access = property_list(H5P_FILE_ACCESS);
  check(H5Pset_fapl_mpio(access, group.comm(), MPI_INFO_NULL), "cannot choose MPI-IO");
  check(H5Pset_coll_metadata_write(access, true), "cannot choose collective metadata");
  return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose, "cannot create"};
}

/// Creates a contiguous dataset of known size, allocated at once and not filled, with units, meanings and checksum as
/// its attributes.
Handle create_dataset(hid_t file, const Section& section, std::uint64_t rows) {
  const std::string what = "cannot create dataset " + section.name;
  const Handle creation = property_list(H5P_DATASET_CREATE);
  check(H5Pset_layout(creation, H5D_CONTIGUOUS), what);
  check(H5Pset_alloc_time(creation, H5D_ALLOC_TIME_EARLY), what);
  check(H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER), what);
  check(H5Pset_obj_track_times(creation, false), what);
  const hsize_t extent = rows;
  const Handle space(H5Screate_simple(1, &extent, nullptr), H5Sclose, what);
  Handle dataset(
      H5Dcreate2(file, section.name.c_str(), packed_type(section.fields), space, H5P_DEFAULT, creation, H5P_DEFAULT),
      H5Dclose, what);
  for (const Field& field : section.fields) {
    write_text(dataset, fmt::format("unit:{}", field.name), std::string(field.unit));
    write_text(dataset, fmt::format("meaning:{}", field.name), std::string(field.meaning));
  }
  write_checksum(dataset, 0);  // until the rows are written
  return dataset;
}

/// The selection of `rows` rows of the dataset from `first` on; `rows` may be 0.
Handle select(hid_t dataset, std::uint64_t first, std::uint64_t rows) {
  Handle space(H5Dget_space(dataset), H5Sclose, "cannot select rows");
  const hsize_t start = first, count = rows;
  check(
      rows == 0 ? H5Sselect_none(space) : H5Sselect_hyperslab(space, H5S_SELECT_SET, &start, nullptr, &count, nullptr),
      "cannot select rows");
  return space;
}

/// The dataspace of `rows` rows in memory.
Handle memory_space(std::uint64_t rows) {
  const hsize_t extent = std::max<std::uint64_t>(rows, 1);
  Handle space(H5Screate_simple(1, &extent, nullptr), H5Sclose, "cannot select rows");
  if (rows == 0) check(H5Sselect_none(space), "cannot select rows");
  return space;
}

/// Writes the rows of all ranks, `bytes` of this one, in one collective write, or in a few if there are very many.
void write_dataset(const RankGroup& group, hid_t dataset, const Section& section, std::uint64_t first,
                   std::span<const std::byte> bytes) {
  const std::string what = "cannot write dataset " + section.name;
  const std::size_t row_size = packed_size(section.fields);
  const std::uint64_t at_a_time = rows_per_transfer(section) * row_size;
  const std::uint64_t transfers = group.max((bytes.size() + at_a_time - 1) / at_a_time);
  Handle transfer, type;
  group.run_collective([&] {
    transfer = property_list(H5P_DATASET_XFER);
    check(H5Pset_dxpl_mpio(transfer, H5FD_MPIO_COLLECTIVE), what);
    // All ranks call, but each writes its own contiguous bytes itself: nothing to gain from passing them on between
    // the ranks first, and there Open MPI hangs when a write fails (disk full) and with some numbers of ranks.
    check(H5Pset_dxpl_mpio_collective_opt(transfer, H5FD_MPIO_INDIVIDUAL_IO), what);
    type = packed_type(section.fields);
  });
  constexpr std::byte none{};  // for a rank without rows
  for (std::uint64_t i = 0; i < transfers; ++i) {
    const auto some = bytes.first(std::min<std::uint64_t>(at_a_time, bytes.size()));
    const std::uint64_t rows = some.size() / row_size;
    Handle in_memory, in_file;
    group.run_collective(
        [&] {  // apart from the write: a rank that fails alone here must not leave the others waiting there
          in_memory = memory_space(rows);
          in_file = select(dataset, first, rows);
        });
    const void* const data = some.empty() ? &none : some.data();
    group.run_collective([&] { check(H5Dwrite(dataset, type, in_memory, in_file, transfer, data), what); });
    first += rows;
    bytes = bytes.subspan(some.size());
  }
}

/// Writes a piece of the block of each rank, and adds its checksums to those of the block.
void write_piece(const RankGroup& group, std::span<const Handle> datasets, std::span<const Section> sections,
                 const PackedBlock& piece, std::span<Checksums> checksums) {
  group.run_collective([&] {
    for (std::size_t i = 0; i < sections.size(); ++i)
      checksums[i].block += checksum_of_rows(piece.sections[i], packed_size(sections[i].fields), piece.first);
  });
  for (std::size_t i = 0; i < sections.size(); ++i)
    write_dataset(group, datasets[i], sections[i], piece.first, piece.sections[i]);
}

Checksums checksums_in_dataset(hid_t file, const Section& section, std::uint64_t total_rows, std::uint64_t first,
                               std::uint64_t rows) {
  const std::string what = "cannot read dataset " + section.name + " back";
  const Handle dataset(H5Dopen2(file, section.name.c_str(), H5P_DEFAULT), H5Dclose, what);
  const Handle stored(H5Dget_type(dataset), H5Tclose, what), type = packed_type(section.fields);
  const Handle space(H5Dget_space(dataset), H5Sclose, what);
  if (H5Tequal(stored, type) <= 0 || H5Sget_simple_extent_npoints(space) != static_cast<hssize_t>(total_rows))
    throw IoError(what + ": it is not what was written");
  return {checksum_of_stored_rows(dataset, first, rows), read_checksum(dataset)};
}

}  // namespace

void reserve_space(const std::string& path, std::uint64_t bytes) {
  const File file(path, O_WRONLY | O_NOFOLLOW);
  int error = file.is_open() ? 0 : errno;
  while (error == 0 || error == EINTR) {
    error = ::posix_fallocate(file.fd(), 0, static_cast<off_t>(bytes));
    if (error == 0) return;
  }
  if (error == EINVAL || error == EOPNOTSUPP) return;  // a file system without: reading back must do
  throw IoError(fmt::format("no room for {} bytes: {}", bytes, reason(error)));
}

std::vector<Checksums> write_part(const RankGroup& group, const std::string& path, const TableInfo& info,
                                  std::span<const Section> sections, std::uint64_t total_rows,
                                  const BlockInPieces& block) {
  Handle file;
  group.run_collective([&] { file = create_file(group, path); });
  const TableInfo common = common_info(group, info);
  std::vector<Handle> datasets;
  group.run_collective([&] {
    write_info(file, table_format, table_format_version, common, total_rows);
    for (const Section& section : sections) datasets.push_back(create_dataset(file, section, total_rows));
  });
  group.run_collective([&] {
    hsize_t bytes = 0;  // with all metadata and the space of the datasets
    check(H5Fget_filesize(file, &bytes), "cannot ask for the file's size");
    if (group.rank() == 0) reserve_space(path, bytes);
  });
  group.run_collective([&] {  // not earlier: MPI-IO does not know the file's size any more once something was written
    if (group.rank() == 0) write_long_texts(file, common);
  });
  std::vector<Checksums> checksums(sections.size());
  for (std::uint64_t i = 0; i < block.pieces; ++i) write_piece(group, datasets, sections, block.next(), checksums);
  for (Checksums& each : checksums) each.dataset = group.sum(each.block);
  group.run_collective([&] {
    for (std::size_t i = 0; i < sections.size(); ++i) {
      checksums[i].dataset += checksum_of_layout(packed_type(sections[i].fields));
      replace_checksum(datasets[i], checksums[i].dataset);
      datasets[i].close("cannot close a dataset");
    }
    check(H5Fflush(file, H5F_SCOPE_GLOBAL), "cannot sync");  // every rank brings its own writes to the disk
    file.close("cannot close");
  });
  return checksums;
}

std::vector<Checksums> checksums_in_part(const std::string& path, std::span<const Section> sections,
                                         std::uint64_t total_rows, std::uint64_t first, std::uint64_t rows) {
  const Handle file = open_unsealed(path);
  if (read_info(file).rows != total_rows) throw IoError("the root attributes are not what was written");
  std::vector<Checksums> checksums;
  for (const Section& section : sections)
    checksums.push_back(checksums_in_dataset(file, section, total_rows, first, rows));
  return checksums;
}

}  // namespace sigmasweep
