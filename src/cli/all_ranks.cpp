#include "cli/all_ranks.hpp"

#include <fmt/format.h>

#include <chrono>
#include <exception>

#include "base/exit_codes.hpp"
#include "base/standard_error.hpp"
#include "cli/complain.hpp"
#include "cli/launcher.hpp"
#include "engine/stop/last_resort.hpp"
#include "engine/stop/stop_signals.hpp"
#include "mpi/rank_group.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/row.hpp"
#include "store/build_info.hpp"

namespace sigmasweep {
namespace {

/// Ends all ranks after an error on one of them, which the others would wait for.
[[noreturn]] void abort_all(const World& world, int exit_code, const char* message) {
  print_on_stderr(fmt::format("sigmasweep: rank {}: {}\n", world.rank(), message));
  world.abort(exit_code);
}

/// Why the ranks cannot work together: they send each other values as bytes, and their last digits are to be the same.
/// The first collective operation of a run. Empty where all ranks are the same build.
std::string why_other_builds(const World& world) {
  const std::string mine = fmt::format("{}\n{}\n{}", build_name(), build_info().git_revision, sizeof(Row));
  const bool is_same = world.broadcast(mine) == mine;
  const std::uint64_t other = RankGroup(world.comm()).max(is_same ? 0 : static_cast<std::uint64_t>(world.rank()));
  if (other == 0) return {};
  return fmt::format("rank {} runs another build of the program than rank 0: all ranks need the same", other);
}

}  // namespace

int on_all_ranks(int& argc, char**& argv, const std::function<int(World&)>& command) {
  const StopSignals signals;  // from here on to the end of MPI
  const LastResort last_resort(launched_rank());
  World world(argc, argv);
  if (const std::string why = why_wrong_launcher(world.size()); !why.empty()) {
    complain(why, Speaker::rank_0);
    return exit_code::usage_error;
  }
  if (const std::string why = why_other_builds(world); !why.empty()) {
    complain(why, Speaker::rank_0);
    return exit_code::usage_error;
  }
  try {
    return command(world);
  } catch (const Error& error) {
    if (!world.is_manager()) abort_all(world, error.exit_code(), error.what());
    // The other ranks know of the error and return the same code. It is printed before MPI ends, because mpirun may end
    // this rank as soon as the first of them is gone.
    print_on_stderr(fmt::format("sigmasweep: {}\n", error.what()));
    // MPI waits at its end for all ranks, which may not know of the error.
    LastResort::end_process_in(std::chrono::seconds(30), error.exit_code());
    return error.exit_code();
  } catch (const std::exception& error) {
    abort_all(world, exit_code::internal_error, error.what());
  }
}

}  // namespace sigmasweep
