#pragma once

#include <string>

#include "store/stored/stored_sweep.hpp"

namespace sigmasweep {

/// Reads what is there of a sweep, for a command that looks at it. Where the sweep is not complete, says so on standard
/// error. Throws as read_stored_sweep().
StoredSweep read_sweep(const std::string& table);

}  // namespace sigmasweep
