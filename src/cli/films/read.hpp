#pragma once

#include <string>
#include <vector>

#include "sigmasweep/model/trajectory.hpp"
#include "store/stored/stored_sweep.hpp"

namespace sigmasweep {

/// The rows that are there and have a trajectory. The sweep must have a table [trajectory].
std::vector<Row> filmed_rows(const StoredSweep& stored);

/// The trajectory of a row, from its file beside the table. Throws InputNotFound if the file is missing, IoError if it
/// does not belong to the row.
Trajectory read_film(const StoredSweep& stored, const std::string& table, const Row& row);

}  // namespace sigmasweep
