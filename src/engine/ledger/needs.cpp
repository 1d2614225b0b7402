#include "engine/ledger/needs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "engine/ledger/identity.hpp"
#include "engine/ledger/usable_memory.hpp"
#include "model/packing.hpp"
#include "store/journal/record.hpp"
#include "sweep/schedule.hpp"

namespace sigmasweep {
namespace {

/// The program, MPI and HDF5 with their buffers; a rank's messages to all others; the piece of the table in hand.
constexpr double program_bytes = 80e6, exchange_bytes = 64e6, piece_bytes = 256.0 * (1 << 20);
/// For each row on rank 0: a bit; its place in the schedule; or after that the keys and quantities of the summary.
constexpr double summary_bytes = 7 * sizeof(double);
constexpr double bookkeeping_bytes = 0.125 + std::max(double(sizeof(ScheduledTask)), summary_bytes);
/// Measured on one core of a Zen 5 machine: the start of Open MPI, and what is done for each row before the first.
constexpr double seconds_to_begin = 0.6, seconds_a_row = 0.5e-6;

double table_bytes(const Sweep& sweep) { return double(packed_size(sweep.columns()) + packed_size(timing_fields())); }

}  // namespace

SweepNeeds needs_of(const Sweep& sweep, std::uint64_t rows, int ranks) {
  const double count = double(rows), packed = count * table_bytes(sweep);
  const double rank_bytes = program_bytes + exchange_bytes + std::min(piece_bytes, packed / ranks);
  const std::vector<Field> results = journalled_results(sweep);
  const double record = double(make_header(journal_identity(sweep, {}, results)).record_size);
  return {.manager_bytes = rank_bytes + count * bookkeeping_bytes,
          .rank_bytes = rank_bytes,
          .disk_bytes = packed + count * record + (1.0 + ranks) * double(sweep.text().size()),
          .seconds_before = seconds_to_begin + count * seconds_a_row};
}

std::string why_too_many(const Sweep& sweep, std::uint64_t rows) {
  constexpr std::uint64_t most_rows = std::numeric_limits<std::int32_t>::max();  // MPI-3 counts by int
  if (rows > most_rows)
    return fmt::format("{} rows are more than one run may have, {}: split the sweep, by --slice say", rows, most_rows);
  const double needed = needs_of(sweep, rows, 1).manager_bytes, memory = usable_memory();
  if (needed <= memory) return {};
  return fmt::format(
      "{} rows take {:.3g} GB of memory on rank 0, which may use {:.3g}: split the sweep, by --slice say", rows,
      needed * 1e-9, memory * 1e-9);
}

}  // namespace sigmasweep
