// The collective table, at every number of ranks that CTest starts this with.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <mpi.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <memory>
#include <optional>
#include <random>
#include <utility>

#include "sigmasweep/base/errors.hpp"
#include "store/hdf5/handle.hpp"
#include "store/table/part.hpp"
#include "store/table/read.hpp"
#include "store/table/write.hpp"
#include "support/store_samples.hpp"

/// Stands in for the C library's while the tests run: a file system that can set no space aside.
static bool can_reserve_space = true;
extern "C" int posix_fallocate(int fd, off_t offset, off_t size) {
  if (!can_reserve_space) return EOPNOTSUPP;
  return fallocate(fd, 0, offset, size) == 0 ? 0 : errno;
}

namespace sigmasweep {
namespace {

using samples::bits;
using samples::bytes_of;
using samples::put_bytes;

int rank_in(MPI_Comm comm) {
  int rank = -1;
  EXPECT_EQ(MPI_Comm_rank(comm, &rank), MPI_SUCCESS);
  return rank;
}
int size_of(MPI_Comm comm) {
  int size = 0;
  EXPECT_EQ(MPI_Comm_size(comm, &size), MPI_SUCCESS);
  return size;
}
void barrier() { EXPECT_EQ(MPI_Barrier(MPI_COMM_WORLD), MPI_SUCCESS); }

/// Rank 0's text everywhere.
std::string from_rank_0(std::string text) {
  text.resize(4096);
  EXPECT_EQ(MPI_Bcast(text.data(), 4096, MPI_CHAR, 0, MPI_COMM_WORLD), MPI_SUCCESS);
  return text.c_str();
}

/// All parameters and results, or the few that a plain sweep has.
std::vector<Field> all_columns() {
  std::vector<Field> columns(parameter_fields().begin(), parameter_fields().end());
  columns.insert(columns.end(), result_fields().begin(), result_fields().end());
  return columns;
}
std::vector<Field> few_columns() {
  std::vector<Field> columns;
  for (const char* name : {"v0", "N", "method", "eps_eff", "contacts", "status"}) columns.push_back(*find_field(name));
  return columns;
}

TableInfo info(const std::string& spec = "[sweep]\nN = 10\n") {
  TableInfo info;
  info.title = "σ-curve, Fig. 2(a)";
  info.spec_text = spec;
  info.host = "node" + std::to_string(rank_in(MPI_COMM_WORLD));
  info.start = "2025-01-01T00:00:00Z";
  info.spec_hash = 0x00c0ffee00c0ffee;
  info.ranks = size_of(MPI_COMM_WORLD);
  return info;
}

/// How `rows` rows are dealt out: evenly; all to the last rank; all to the first; unevenly with empty blocks between.
enum class Deal { even, last, first, gaps };

/// First row and number of rows of a rank's block.
std::pair<std::uint64_t, std::uint64_t> block_of(Deal deal, std::uint64_t rows, int rank, int size) {
  const auto rows_before = [&](int r) -> std::uint64_t {
    if (r == 0) return 0;
    if (r == size || deal == Deal::first) return rows;
    if (deal == Deal::last) return 0;
    const int counted = deal == Deal::even ? r : r / 2 * 2;  // gaps: ranks 0, 2, ... get nothing but at the end
    return rows * static_cast<unsigned>(counted) / static_cast<unsigned>(size);
  };
  return {rows_before(rank), rows_before(rank + 1) - rows_before(rank)};
}

void write(MPI_Comm comm, const std::string& path, const std::vector<Field>& columns, std::uint64_t rows, Deal deal,
           const TableInfo& about) {
  const auto [first, count] = block_of(deal, rows, rank_in(comm), size_of(comm));
  const std::vector<Row> block = samples::rows(first, count);
  write_table(comm, path, about, columns, rows, first, block);
}

/// The dataset's bytes as they lie in the file.
std::string raw_bytes(const std::string& path, const char* name) {
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "open");
  const Handle dataset(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose, "open");
  const auto size = H5Dget_storage_size(dataset);
  return size == 0 ? std::string() : bytes_of(path).substr(H5Dget_offset(dataset), size);
}

class TableTest : public testing::Test {
 protected:
  void SetUp() override {
    if (rank == 0) own = std::make_unique<samples::Directory>();
    directory = from_rank_0(own ? own->file("") : "");
    path = directory + "t.h5";
  }
  void TearDown() override { barrier(); }

  /// Every rank must throw this kind of error with the same message, which is returned.
  template <class Kind>
  std::string message_on_all(const std::function<void()>& action) {
    std::string mine = samples::message_of<Kind>(action);
    EXPECT_EQ(mine, from_rank_0(mine));
    return mine;
  }

  int rank = rank_in(MPI_COMM_WORLD), size = size_of(MPI_COMM_WORLD);
  std::unique_ptr<samples::Directory> own;
  std::string directory, path;
};

TEST_F(TableTest, ReadsBackWhatWasWritten) {
  for (const Deal deal : {Deal::even, Deal::last, Deal::first, Deal::gaps})
    for (const std::uint64_t rows : {0, 1, 2, 3, 1000}) {
      SCOPED_TRACE(testing::Message() << rows << " rows, deal " << static_cast<int>(deal));
      write(MPI_COMM_WORLD, path, all_columns(), rows, deal, info());
      const Table table = read_table(path);
      ASSERT_EQ(table.rows.size(), rows);
      for (std::uint64_t k = 0; k < rows; ++k) ASSERT_EQ(bits(table.rows[k]), bits(samples::row(k))) << k;
      ASSERT_EQ(table.columns.size(), all_columns().size());
      for (std::size_t i = 0; i < table.columns.size(); ++i) EXPECT_EQ(table.columns[i].name, all_columns()[i].name);
      EXPECT_EQ(table.info.title, "σ-curve, Fig. 2(a)");
      EXPECT_EQ(table.info.spec_text, info().spec_text);
      EXPECT_EQ(table.info.spec_hash, 0x00c0ffee00c0ffeeu);
      EXPECT_EQ(table.info.host, "node0");  // rank 0's, although every rank brought another
      EXPECT_EQ(table.info.start, "2025-01-01T00:00:00Z");
      EXPECT_EQ(table.info.ranks, size);
      barrier();
      if (rank == 0) {
        EXPECT_EQ(own->names(), std::vector<std::string>{"t.h5"});
      }
      barrier();
    }
}

TEST_F(TableTest, MembersThatAreNotColumnsKeepTheirDefaults) {
  write(MPI_COMM_WORLD, path, few_columns(), 20, Deal::even, info());
  const Table table = read_table(path);
  for (const Row& row : table.rows) {
    EXPECT_EQ(row.parameters.v0, samples::row(row.index).parameters.v0);
    EXPECT_EQ(row.parameters.N, samples::row(row.index).parameters.N);
    EXPECT_EQ(row.result.status, samples::row(row.index).result.status);
    EXPECT_EQ(row.parameters.tc, Parameters().tc);
    EXPECT_TRUE(std::isnan(row.result.t_k));
    EXPECT_EQ(row.timing.run_time, samples::row(row.index).timing.run_time);
  }
}

TEST_F(TableTest, ResultsAreTheSameBitsForAnyNumberOfRanks) {
  write(MPI_COMM_WORLD, path, all_columns(), 1234, Deal::gaps, info());
  const std::string alone = directory + "alone.h5";
  if (rank == 0) {
    write(MPI_COMM_SELF, alone, all_columns(), 1234, Deal::even, info());
    const std::string wanted = raw_bytes(alone, "results");
    std::size_t bytes = 0;  // of a packed row: nothing between the members
    for (const Field& field : all_columns()) bytes += enumerators(field.type).empty() ? 8 : 1;
    EXPECT_EQ(wanted.size(), 1234u * bytes);
    EXPECT_EQ(raw_bytes(path, "results"), wanted);
    EXPECT_EQ(bytes_of(path), bytes_of(alone));  // here the timings, hosts and ranks are the same too
  }
}

TEST_F(TableTest, RowsAreReadAsTheyAreAskedFor) {
  write(MPI_COMM_WORLD, path, all_columns(), 70'000, Deal::even, info());
  barrier();
  TableRows rows(path);
  ASSERT_EQ(rows.size(), 70'000u);
  for (const std::uint64_t k : {69'999u, 0u, 65'535u, 65'536u, 1u})
    EXPECT_EQ(bits(rows[k]), bits(samples::row(k))) << k;
  EXPECT_THROW(TableRows(directory + "missing.h5"), InputNotFound);
}

TEST_F(TableTest, ABlockInPiecesGivesTheSameTable) {
  constexpr std::uint64_t total = 100, at_a_time = 7, pieces = 15;
  const std::vector<Field> columns = all_columns();
  write(MPI_COMM_WORLD, path, columns, total, Deal::even, info());
  barrier();
  const std::string results = raw_bytes(path, "results"), timings = raw_bytes(path, "timings");
  const std::string whole = bytes_of(path);
  barrier();
  const auto [first, count] = block_of(Deal::even, total, rank, size);
  std::uint64_t done = 0;
  std::optional<PackedRows> piece;
  const BlockInPieces block(first, count, pieces, [&, first = first, count = count] {
    const std::uint64_t now = std::min(at_a_time, count - done), place = first + std::exchange(done, done + now);
    piece.emplace(columns, samples::rows(place, now));
    return PackedBlock(place, *piece, now);
  });
  write_table(MPI_COMM_WORLD, path, info(), columns, total, block);
  barrier();
  EXPECT_TRUE(bytes_of(path) == whole);
  EXPECT_TRUE(raw_bytes(path, "results") == results && raw_bytes(path, "timings") == timings);
  ASSERT_EQ(read_table(path).rows.size(), total);
}

TEST_F(TableTest, WritesMoreThanOneTransferTakes) {
  constexpr std::uint64_t rows = 300'000;  // 41 MiB of results, a transfer is 32
  write(MPI_COMM_WORLD, path, all_columns(), rows, Deal::last, info());
  if (rank == 0) {
    const Table table = read_table(path);
    ASSERT_EQ(table.rows.size(), rows);
    for (std::uint64_t k = 0; k < rows; ++k) ASSERT_EQ(bits(table.rows[k]), bits(samples::row(k))) << k;
  }
}

TEST_F(TableTest, KeepsASpecLargerThanAnHdf5HeaderMessage) {
  const std::string spec(200'000, 's');
  write(MPI_COMM_WORLD, path, few_columns(), 5, Deal::even, info(spec));
  EXPECT_EQ(read_table(path).info.spec_text, spec);
}

TEST_F(TableTest, ReplacesAnOlderTable) {
  write(MPI_COMM_WORLD, path, few_columns(), 50, Deal::even, info());
  write(MPI_COMM_WORLD, path, few_columns(), 5, Deal::even, info());
  EXPECT_EQ(read_table(path).rows.size(), 5u);
}

TEST_F(TableTest, EveryRankHearsWhyItCannotBeCreated) {
  const std::string nowhere = directory + "missing/t.h5";
  const auto message =
      message_on_all<OutputError>([&] { write(MPI_COMM_WORLD, nowhere, few_columns(), 5, Deal::even, info()); });
  EXPECT_NE(message.find(nowhere), std::string::npos) << message;
  EXPECT_NE(message.find("No such file"), std::string::npos) << message;
}

TEST_F(TableTest, ADirectoryInItsPlaceIsAnError) {
  if (rank == 0) std::filesystem::create_directory(path);
  barrier();
  message_on_all<OutputError>([&] { write(MPI_COMM_WORLD, path, few_columns(), 5, Deal::even, info()); });
  if (rank == 0) {
    EXPECT_EQ(own->names(), std::vector<std::string>{"t.h5"});
  }
}

TEST_F(TableTest, BlocksThatDoNotMakeUpTheTableAreAnError) {
  const std::vector<Row> mine = samples::rows(static_cast<std::uint64_t>(rank) * 10, 10);
  const auto total = static_cast<std::uint64_t>(size) * 10;
  message_on_all<IoError>([&] {  // one row too few
    write_table(MPI_COMM_WORLD, path, info(), few_columns(), total + 1, mine.front().index, mine);
  });
  message_on_all<IoError>([&] {  // the last rank's are others than it says
    const auto first = mine.front().index + (rank == size - 1 ? 1 : 0);
    write_table(MPI_COMM_WORLD, path, info(), few_columns(), total, first, mine);
  });
  if (rank == 0) {
    EXPECT_TRUE(own->names().empty());
  }
}

/// A limit on the size of files, for as long as it lives: stands for a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    EXPECT_EQ(getrlimit(RLIMIT_FSIZE, &before_), 0);
    const rlimit small{bytes, before_.rlim_max};
    EXPECT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  }
  ~FileSizeLimit() {
    EXPECT_EQ(setrlimit(RLIMIT_FSIZE, &before_), 0);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST_F(TableTest, WithoutRoomTheOldTableStaysAndNothingElse) {
  for (const bool can_reserve : {true, false}) {
    SCOPED_TRACE(can_reserve);
    write(MPI_COMM_WORLD, path, few_columns(), 50, Deal::even, info());
    const std::string before = bytes_of(path);
    barrier();
    can_reserve_space = can_reserve;
    {
      const FileSizeLimit limit(100'000);
      const auto message =
          message_on_all<IoError>([&] { write(MPI_COMM_WORLD, path, all_columns(), 10'000, Deal::even, info()); });
      EXPECT_NE(message.find(can_reserve ? "no room" : "cannot write dataset results"), std::string::npos) << message;
    }
    can_reserve_space = true;
    EXPECT_EQ(bytes_of(path), before);
    barrier();
    if (rank == 0) {
      EXPECT_EQ(own->names(), std::vector<std::string>{"t.h5"});
    }
    barrier();
  }
}

TEST_F(TableTest, AFileSystemThatCannotReserveSpaceIsGoodEnough) {
  can_reserve_space = false;
  write(MPI_COMM_WORLD, path, few_columns(), 50, Deal::even, info());
  can_reserve_space = true;
  EXPECT_EQ(read_table(path).rows.size(), 50u);
}

TEST_F(TableTest, ReadingBackSeesAFlippedBitAndACutFile) {
  const auto columns = all_columns();
  const std::array sections{Section{"results", columns}, Section{"timings", timing_fields()}};
  const auto [first, count] = block_of(Deal::even, 100, rank, size);
  const std::vector<Row> block = samples::rows(first, count);
  const Hdf5Session session;
  const RankGroup group(MPI_COMM_WORLD);
  if (rank == 0) put_bytes(path, "");
  barrier();
  const PackedRows packed(columns, block);
  const auto written = write_part(group, path, info(), sections, 100, PackedBlock(first, packed, count));
  EXPECT_EQ(checksums_in_part(path, sections, 100, first, count), written);
  barrier();
  if (rank != 0) return;
  const std::string whole = bytes_of(path);
  const auto sums = checksums_in_part(path, sections, 100, 0, 100);
  for (const char* name : {"results", "timings"}) {
    std::string damaged = whole;
    damaged[whole.find(raw_bytes(path, name)) + 777] ^= 4;
    put_bytes(path, damaged);
    EXPECT_NE(checksums_in_part(path, sections, 100, 0, 100), sums);
    put_bytes(path, whole);
  }
  put_bytes(path, std::string(whole.size(), '\0'));  // what a full disk leaves
  EXPECT_THROW(checksums_in_part(path, sections, 100, 0, 100), IoError);
  for (std::size_t cut = 0; cut < whole.size(); cut += 61) {
    put_bytes(path, whole.substr(0, cut));
    EXPECT_THROW(checksums_in_part(path, sections, 100, 0, 100), IoError) << cut;
    EXPECT_THROW(read_table(path), IoError) << cut;
  }
  put_bytes(path, whole);
  EXPECT_EQ(checksums_in_part(path, sections, 100, 0, 100), sums);
}

/// Whether the table can be read, and then is the same in everything that a result hangs on.
testing::AssertionResult refused_or_same(const std::string& path, const Table& wanted, bool must_be_refused) {
  try {
    const Table table = read_table(path);
    if (must_be_refused) return testing::AssertionFailure() << "it was read";
    if (table.columns.size() != wanted.columns.size() || table.rows.size() != wanted.rows.size() ||
        table.info.slice != wanted.info.slice || table.info.physics_version != wanted.info.physics_version)
      return testing::AssertionFailure() << "another table was read";
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      if (table.columns[i].name != wanted.columns[i].name) return testing::AssertionFailure() << "another column";
    for (std::size_t k = 0; k < table.rows.size(); ++k)
      if (bits(table.rows[k]) != bits(wanted.rows[k])) return testing::AssertionFailure() << "another row " << k;
  } catch (const IoError& error) {
    if (std::string(error.what()).find(path) == std::string::npos)
      return testing::AssertionFailure() << "which file? " << error.what();
  }
  return testing::AssertionSuccess();
}

TEST_F(TableTest, AFlippedBitIsNeverReadForARow) {
  constexpr std::uint64_t rows = 20;
  write(MPI_COMM_WORLD, path, all_columns(), rows, Deal::gaps, info());
  if (rank != 0) return;
  const auto seed = std::random_device{}();
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::minstd_rand random(seed);
  const Table wanted = read_table(path);
  const std::string sealed = bytes_of(path), damaged_path = directory + "damaged.h5";
  const std::string whole = sealed.substr(0, sealed.size() - 16);
  const auto flip = [&](const std::string& of, std::size_t begin, std::size_t bytes, bool must_be_refused) {
    std::string damaged = of;
    const std::size_t byte = begin + random() % bytes, bit = random() % 8;
    damaged[byte] = static_cast<char>(damaged[byte] ^ (1 << bit));
    put_bytes(damaged_path, damaged);
    return testing::AssertionResult(refused_or_same(damaged_path, wanted, must_be_refused))
           << " (bit " << bit << " of byte " << byte << ")";
  };
  for (const char* name : {"results", "timings"}) {
    const std::string data = raw_bytes(path, name);
    for (int i = 0; i < 1000; ++i) ASSERT_TRUE(flip(whole, whole.find(data), data.size(), true)) << name;
  }
  for (int i = 0; i < 2000; ++i) ASSERT_TRUE(flip(sealed, 0, sealed.size(), false));
}

}  // namespace
}  // namespace sigmasweep
