#pragma once

#include <cstdint>
#include <exception>

#include "base/exit_codes.hpp"
#include "mpi/world.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {

/// Runs `step`, which returns an exit code, on the manager. If it throws, the manager throws the same error; the other
/// ranks return the error's exit code, so that no rank is left waiting. Collective.
template <class Step>
int run_on_root(const World& world, Step step) {
  std::exception_ptr error;
  int code = exit_code::success;
  if (world.is_manager()) {
    try {
      code = step();
    } catch (const Error& e) {
      code = e.exit_code();
      error = std::current_exception();
    } catch (...) {
      code = exit_code::internal_error;
      error = std::current_exception();
    }
  }
  code = static_cast<int>(world.broadcast(std::int64_t{code}));
  if (error) std::rethrow_exception(error);
  return code;
}

}  // namespace sigmasweep
