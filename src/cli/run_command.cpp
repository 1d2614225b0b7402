#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <thread>

#include "base/exit_codes.hpp"
#include "cli/commands.hpp"
#include "mpi/on_root.hpp"
#include "mpi/world.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {
namespace {

/// What one rank alone runs into ends all: nobody must wait for it.
[[noreturn]] void abort_all(const World& world, int exit_code, const char* what) {
  fmt::print(stderr, "sigmasweep: rank {}: {}\n", world.rank(), what);
  world.abort(exit_code);
}

/// MPI waits for all ranks at its end. What the manager met alone, unknown to the others, must not make it wait for
/// ever.
void end_soon(int exit_code) {
  std::thread([exit_code] {
    std::this_thread::sleep_for(std::chrono::seconds(30));
    std::_Exit(exit_code);
  }).detach();
}

template <class Command>
int on_all_ranks(int& argc, char**& argv, Command command) {
  World world(argc, argv);
  try {
    return command(world);
  } catch (const Error& error) {
    if (!world.is_manager()) abort_all(world, error.exit_code(), error.what());
    // The other ranks know, and leave with the same code. Say it before MPI ends: once the first of them is gone,
    // mpirun may end this rank too.
    fmt::print(stderr, "sigmasweep: {}\n", error.what());
    end_soon(error.exit_code());
    return error.exit_code();
  } catch (const std::exception& error) {
    abort_all(world, exit_code::internal_error, error.what());
  }
}

}  // namespace

int run_on_all_ranks(int& argc, char**& argv, const RunOptions& options) {
  return on_all_ranks(argc, argv, [&](World& world) { return run(world, options); });
}

int precision_on_all_ranks(int& argc, char**& argv, const PrecisionOptions& options) {
  return on_all_ranks(argc, argv, [&](World& world) { return precision(world, options); });
}

int stability_on_all_ranks(int& argc, char**& argv, const StabilityOptions& options) {
  return on_all_ranks(argc, argv, [&](World& world) { return stability(world, options); });
}

int merge_on_one_rank(int& argc, char**& argv, const MergeOptions& options) {
  return on_all_ranks(argc, argv, [&](World& world) { return run_on_root(world, [&] { return merge(options); }); });
}

}  // namespace sigmasweep
