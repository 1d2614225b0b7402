#include "engine/trajectories/trajectory_files.hpp"

#include <fmt/format.h>

#include "base/output/place.hpp"
#include "engine/run_options.hpp"

namespace sigmasweep {

std::string trajectory_directory(const std::string& table) { return named_after(linked_file(table), ".trajectories"); }

std::string trajectory_file(const std::string& table, std::uint64_t row) {
  return fmt::format("{}/row-{:06}.h5", trajectory_directory(table), row);
}

}  // namespace sigmasweep
