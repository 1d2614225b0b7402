#include "engine/ledger/needs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "engine/ledger/usable_memory.hpp"
#include "model/packing.hpp"
#include "store/journal/record.hpp"
#include "sweep/schedule.hpp"

namespace sigmasweep {
namespace {

constexpr double program_bytes = 80e6;  // the program, MPI and HDF5 with their buffers
/// For each row: whether it is there, its place in the schedule, and after that the keys and times of the summary.
constexpr double bookkeeping_bytes = 1.0 + std::max(sizeof(ScheduledTask), 3 * sizeof(double)) + 2 * sizeof(double);
/// Measured on one core of a Zen 5 machine: the start of Open MPI, and what is done for each row before the first.
constexpr double seconds_to_begin = 0.6, seconds_a_row = 0.5e-6;

double table_bytes(const Sweep& sweep) { return double(packed_size(sweep.columns()) + packed_size(timing_fields())); }

}  // namespace

SweepNeeds needs_of(const Sweep& sweep, std::uint64_t rows, int ranks) {
  const double count = double(rows), packed = count * table_bytes(sweep);
  return {.manager_bytes = program_bytes + packed + count * bookkeeping_bytes,
          .rank_bytes = program_bytes + packed / ranks,
          .disk_bytes = packed + count * double(make_header({}).record_size) + 2.0 * double(sweep.text().size()),
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
