#pragma once

#include <cstdint>
#include <string>

namespace sigmasweep {

/// The directory of the trajectories of a table: fig1.trajectories beside fig1.h5.
std::string trajectory_directory(const std::string& table);

/// The file of a row: fig1.trajectories/row-000042.h5.
std::string trajectory_file(const std::string& table, std::uint64_t row);

}  // namespace sigmasweep
