#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "store/run_notes/machine.hpp"

/// The bytes of a file of run notes, TABLE.h5.running: a page with the header, a page for each rank, and pairs of a row
/// and its suspicion score. Each page is written by one process only, so that machines which share the file through a
/// network do not overwrite each other: they exchange whole pages. Numbers are stored as the machine has them.
namespace sigmasweep::notes {

inline constexpr std::uint64_t magic = 0x0a334e5552575353;  // "SSWRUN3\n" on a little-endian machine

/// The first page. The manager alone writes it.
struct Header {
  std::uint64_t is_magic = magic;
  std::uint64_t spec_hash = 0, rows = 0, run = 0;
  std::uint64_t ranks = 0;      ///< 0 after a run that came to its end
  std::uint64_t page_size = 0;  ///< bytes
  std::uint64_t suspected = 0;  ///< number of pairs
  std::uint64_t done = 0;       ///< rows that this run has finished
  double seconds = 0.0;         ///< since it began to compute
  double seconds_left = 0.0;    ///< estimate; NaN: unknown
};

inline constexpr std::uint64_t max_noted_rows = 256;

/// The page of a rank. Times are those of the machine's monotonic clock, ns.
struct RankPage {
  std::uint64_t row_plus_1 = 0;  ///< the row that is computed, the first of a batch; 0: none
  std::int64_t began = 0;        ///< when the row was begun
  std::int64_t beat = 0;         ///< the last heartbeat
  ProcessId process{};
  Machine machine{};
  std::array<char, 64> host{};                       ///< ends with a zero
  std::uint64_t batch = 0;                           ///< number of rows that are computed side by side; 0: one
  std::array<std::uint64_t, max_noted_rows> rows{};  ///< of the batch
};

struct Suspicion {
  std::uint64_t row = 0, score = 0;
};

inline constexpr std::uint64_t min_page_size = 4096, max_page_size = 1 << 20, max_ranks = 1 << 20;
static_assert(sizeof(Header) <= min_page_size && sizeof(RankPage) <= min_page_size);

}  // namespace sigmasweep::notes
