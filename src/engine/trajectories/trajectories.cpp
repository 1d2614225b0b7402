#include "engine/trajectories/trajectories.hpp"

#include <fmt/format.h>
#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string_view>
#include <system_error>

#include "engine/trajectories/trajectory_files.hpp"
#include "mpi/run_collective.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/trajectory/trajectory.hpp"
#include "store/h5md.hpp"
#include "store/table/place.hpp"

namespace sigmasweep {
namespace {

namespace fs = std::filesystem;

bool exists(const std::string& path) {
  std::error_code error;
  return fs::exists(fs::symlink_status(path, error));
}

[[noreturn]] void refuse(const std::string& path, std::uint64_t row) {
  throw OutputError(
      fmt::format("{}: is there already and is not the trajectory of row {} of this sweep; nothing was "
                  "changed. Choose another output with -o, or --fresh to replace it; --fresh leaves what is not of "
                  "this program or behind a link",
                  path, row));
}

/// Whether this is the name of a row's file, or of one that a killed run left unfinished.
bool is_file_of_a_row(std::string_view name) {
  constexpr std::size_t least_digits = 6;
  if (!name.starts_with("row-")) return false;
  name.remove_prefix(4);
  const std::size_t digits = std::min(name.find_first_not_of("0123456789"), name.size());
  const std::string_view ending = name.substr(digits);
  return digits >= least_digits && (ending == ".h5" || ending == ".h5.part");
}

/// Whether a file is a trajectory of this program, or the beginning of one.
bool may_be_removed(const fs::path& path) {
  std::error_code error;
  if (!is_file_of_a_row(path.filename().string()) || !fs::is_regular_file(fs::symlink_status(path, error)))
    return false;
  return path.extension() == ".part" || is_file_of_ours(path.string(), "sigmasweep");
}

bool is_own_directory(const std::string& directory) {
  std::error_code error;
  return fs::is_directory(fs::symlink_status(directory, error));
}

void remove_files(const std::string& directory) {
  if (!is_own_directory(directory)) return;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(directory, error)) {
    if (!may_be_removed(entry.path())) continue;
    if (!fs::remove(entry.path(), error) && error)
      throw OutputError(fmt::format("cannot remove {}: {}", entry.path().string(), error.message()));
  }
}

double duration_of(const TrajectorySpec& spec, const Row& row) {
  return spec.duration > 0.0 ? spec.duration : show_time(row.parameters, row.result);
}

/// The rows whose trajectories are wanted, ordered for World::scatter(), so that rank r gets every size-th row from r
/// on.
std::vector<Row> rows_by_rank(const Sweep& sweep, const RowSource& rows, int ranks) {
  std::vector<Row> chosen, by_rank;
  for (const std::uint64_t row : sweep.trajectory()->rows) {
    const Row done = rows[row];
    if (std::isfinite(show_time(done.parameters, done.result))) chosen.push_back(done);  // no result, no trajectory
  }
  for (std::size_t rank = 0; rank < static_cast<std::size_t>(ranks); ++rank)
    for (std::size_t k = rank; k < chosen.size(); k += static_cast<std::size_t>(ranks)) by_rank.push_back(chosen[k]);
  return by_rank;
}

void write(const TrajectorySpec& spec, const std::string& table, const Row& row) {
  const std::string path = trajectory_file(table, row.index);
  const double duration = duration_of(spec, row);
  if (exists(path)) {
    if (!is_h5md_of(path, row.parameters, spec.samples, duration)) refuse(path, row.index);
    return;
  }
  write_h5md(path, {row.index, row.parameters}, record(row.parameters, sample_times(duration, spec.samples)));
}

void make_directory(const std::string& directory) {
  std::error_code error;
  fs::create_directory(directory, error);
  if (error || !fs::is_directory(directory))
    throw OutputError(fmt::format("cannot create {}: {}", directory, error ? error.message() : "it is a file"));
}

}  // namespace

void remove_trajectories(const Sweep& sweep, const std::string& table) {
  if (sweep.trajectory()) remove_files(trajectory_directory(table));
}

void require_own_trajectories(const Sweep& sweep, const std::string& table, bool fresh) {
  if (!sweep.trajectory()) return;
  const TrajectorySpec& spec = *sweep.trajectory();
  const std::string directory = trajectory_directory(table);
  if (!exists(directory)) return;
  const bool removes = fresh && is_own_directory(directory);
  const double duration = spec.duration > 0.0 ? spec.duration : std::numeric_limits<double>::quiet_NaN();
  for (const std::uint64_t row : spec.rows)
    if (const std::string path = trajectory_file(table, row);
        exists(path) && !(removes && may_be_removed(path)) && !is_h5md_of(path, sweep.at(row), spec.samples, duration))
      refuse(path, row);
}

TrajectoryCount write_trajectories(const World& world, const Sweep& sweep, const std::string& table,
                                   const RowSource& rows, const StopRequest& stop) {
  const auto comm = world.comm();
  std::vector<Row> all;
  const std::uint64_t wanted = run_collective(comm, [&] {
    if (!world.is_manager()) return std::uint64_t{0};
    make_directory(trajectory_directory(table));
    all = rows_by_rank(sweep, rows, world.size());
    return std::uint64_t{all.size()};
  });
  const std::vector<Row> mine = world.scatter(all, wanted);
  const std::uint64_t written = run_collective(comm, [&] {
    std::uint64_t done = 0;
    for (const Row& row : mine) {
      if (stop.made()) break;
      write(*sweep.trajectory(), table, row);
      ++done;
    }
    return done;
  });
  return {wanted, written};
}

}  // namespace sigmasweep
