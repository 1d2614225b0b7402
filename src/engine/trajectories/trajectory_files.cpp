#include "engine/trajectories/trajectory_files.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace sigmasweep {

std::string trajectory_directory(const std::string& table) {
  std::filesystem::path path(table);
  if (path.extension() == ".h5" || path.extension() == ".hdf5") path.replace_extension();
  return path.string() + ".trajectories";
}

std::string trajectory_file(const std::string& table, std::uint64_t row) {
  return fmt::format("{}/row-{:06}.h5", trajectory_directory(table), row);
}

}  // namespace sigmasweep
