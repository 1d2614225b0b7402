#pragma once

#include <optional>
#include <string>
#include <vector>

#include "store/run_notes/format.hpp"

namespace sigmasweep::notes {

/// All that a file of run notes holds.
struct Contents {
  Header header;
  std::vector<RankPage> ranks;
  std::vector<Suspicion> suspicions;
};

/// The file beside a table.
std::string path_of(const std::string& table);

/// Reads the file, which other processes may be writing. Nothing if there is none, or if it is not of this format.
/// Throws IoError if reading fails.
std::optional<Contents> read(const std::string& path);

/// Makes the file. Each page takes space on the disk from the start, so that a full disk is met here. Throws
/// OutputError.
void write(const std::string& path, const Contents& contents);

}  // namespace sigmasweep::notes
