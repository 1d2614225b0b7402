#pragma once

#include "base/exit_codes.hpp"
#include "mpi/on_root.hpp"
#include "mpi/world.hpp"
#include "sigmasweep/base/errors.hpp"

/// The phases of a run are functions that are called on all ranks and return a value on each. If the manager meets an
/// error, the manager throws it; the other ranks throw FailedOnManager.
namespace sigmasweep {

/// The manager met an error, which ends the run with this exit code. Thrown on ranks other than the manager.
struct FailedOnManager {
  int exit_code;
};

/// Runs `step` on the manager. Collective.
template <class Step>
void on_manager(const World& world, Step step) {
  const int code = run_on_root(world, [&] {
    step();
    return exit_code::success;
  });
  if (code != exit_code::success) throw FailedOnManager{code};
}

/// Runs on every rank a step that throws the same Error on all ranks, if any: the manager's is enough. Collective.
template <class Step>
void on_all_ranks(const World& world, Step step) {
  try {
    step();
  } catch (const Error& error) {
    if (world.is_manager()) throw;
    throw FailedOnManager{error.exit_code()};
  }
}

}  // namespace sigmasweep
