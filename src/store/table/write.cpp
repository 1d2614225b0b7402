#include "store/table/write.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>

#include "base/atomic_file.hpp"
#include "base/output/place.hpp"
#include "model/packing.hpp"
#include "mpi/rank_group.hpp"
#include "store/hdf5/handle.hpp"
#include "store/hdf5/seal.hpp"
#include "store/table/part.hpp"

namespace sigmasweep {
namespace {

constexpr const char* part_suffix = ".part";

std::string part_of(const std::string& path) { return beside(path, part_suffix); }

/// Removes the files that Open MPI keeps beside a file while ranks have it open together. Ranks that are killed leave
/// them behind.
void remove_mpi_files_of(const std::string& part) {
  namespace fs = std::filesystem;
  const fs::path path(part);
  const std::string name = path.filename();
  std::error_code none;  // a file that cannot be removed does no harm
  for (fs::directory_iterator it(path.has_parent_path() ? path.parent_path() : ".", none), end; it != end;
       it.increment(none)) {
    const std::string other = it->path().filename();
    if (!other.starts_with(name)) continue;
    const std::string_view rest = std::string_view(other).substr(name.size());
    if ((rest.starts_with('-') && rest.ends_with(".lock")) || rest.starts_with(".data.") ||
        rest.starts_with(".metadata."))
      ::unlink(it->path().c_str());
  }
}

/// Makes an empty file and finds out whether the disk has room for the table, before HDF5 is asked to do anything: with
/// a full disk HDF5 over MPI-IO reports success all along. On rank 0.
void prepare(const std::string& path, std::optional<AtomicFile>& file, std::uint64_t bytes) {
  require_file_place(path, "a table needs a file");
  remove_mpi_files_of(part_of(path));
  file.emplace(path, part_suffix);
  file->close();
  reserve_space(file->part(), bytes);
}

/// Throws OutputError if this rank cannot open the file that rank 0 created: the file systems of the ranks may differ,
/// and a rank that fails later would leave the others waiting for it.
void see_same_file(const std::string& part, int rank) {
  if (!File(part, O_RDWR | O_NOFOLLOW).is_open())
    throw OutputError(
        fmt::format("rank {} cannot open {}, which rank 0 created: {}. All ranks need the same file "
                    "system",
                    rank, part, reason(errno)));
}

/// Requires that the blocks cover the table: nothing would fill a gap.
void check_blocks(const RankGroup& group, std::uint64_t total_rows, const BlockInPieces& block) {
  const std::uint64_t rows = group.sum(block.rows), before = group.sum_before(block.rows);
  group.run_collective([&] {
    if (rows != total_rows || block.first != before)
      throw std::logic_error(fmt::format("the ranks' blocks do not make up {} rows", total_rows));
  });
}

/// Every rank reads the rows of another rank: its own rows it might find in its own machine's memory.
void read_back(const RankGroup& group, const std::string& part, std::span<const Section> sections,
               std::uint64_t total_rows, const BlockInPieces& block, const std::vector<Checksums>& checksums) {
  std::vector<std::uint64_t> message{block.first, block.rows};
  for (const Checksums& each : checksums) message.push_back(each.block);
  const int before = (group.rank() + group.size() - 1) % group.size(), next = (group.rank() + 1) % group.size();
  check_mpi(MPI_Sendrecv_replace(message.data(), static_cast<int>(message.size()), MPI_UINT64_T, before, 0, next, 0,
                                 group.comm(), MPI_STATUS_IGNORE),
            "cannot exchange checksums");
  group.run_collective([&] {
    const auto found = checksums_in_part(part, sections, total_rows, message[0], message[1]);
    for (std::size_t i = 0; i < sections.size(); ++i)
      if (found[i] != Checksums{message[2 + i], checksums[i].dataset})
        throw IoError(fmt::format("rows {} to {} of {} read back are not what was written", message[0],
                                  message[0] + message[1] - 1, sections[i].name));
  });
}

/// Makes the file the complete table. From here on it stays, whatever happens.
void publish(AtomicFile& file) {
  seal(file.part());
  file.publish();
  sync_directory_of(file.part());
}

void write_collective(const RankGroup& group, const std::string& path, const TableInfo& info,
                      std::span<const Section> sections, std::uint64_t total_rows, const BlockInPieces& block) {
  const std::string part = part_of(path);
  std::uint64_t bytes = (std::uint64_t{1} << 16) + 2 * (info.title.size() + info.spec_text.size());
  for (const Section& section : sections) bytes += total_rows * packed_size(section.fields);
  check_blocks(group, total_rows, block);
  std::optional<AtomicFile> file;  // on rank 0; it removes what is not published
  group.run_collective([&] {
    if (group.rank() == 0) prepare(path, file, bytes);
  });
  group.run_collective([&] { see_same_file(part, group.rank()); });
  const auto checksums = write_part(group, part, info, sections, total_rows, block);
  read_back(group, part, sections, total_rows, block, checksums);
  group.run_collective([&] {
    if (group.rank() == 0) publish(*file);
  });
}

}  // namespace

void write_table(MPI_Comm comm, const std::string& path, const TableInfo& info, std::span<const Field> columns,
                 std::uint64_t total_rows, std::uint64_t first, std::span<const Row> block) {
  const PackedRows packed(columns, block);
  write_table(comm, path, info, columns, total_rows, PackedBlock(first, packed, block.size()));
}

void write_table(MPI_Comm comm, const std::string& path, const TableInfo& info, std::span<const Field> columns,
                 std::uint64_t total_rows, const BlockInPieces& block) {
  const Hdf5Session session;
  const RankGroup group(comm);
  const std::array sections{Section{"results", columns}, Section{"timings", timing_fields()}};
  try {
    write_collective(group, path, info, sections, total_rows, block);
  } catch (const OutputError& error) {
    throw OutputError(fmt::format("cannot write {}: {}", path, error.what()));
  } catch (const IoError& error) {
    throw IoError(fmt::format("cannot write {}: {}", path, error.what()));
  }
}

}  // namespace sigmasweep
