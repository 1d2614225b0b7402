#pragma once

#include <string>

#include "store/films/formats.hpp"
#include "store/stored/stored_sweep.hpp"

namespace sigmasweep {

/// Writes the trajectories of a table, in a format of viewers, into a directory, which is made if it is not there.
/// Throws UsageError for a sweep without trajectories, OutputError, and the errors of read_film().
void export_films(const StoredSweep& stored, const std::string& table, const FilmFormat& format,
                  const std::string& directory);

}  // namespace sigmasweep
