#include "engine/run_options.hpp"

#include <filesystem>

namespace sigmasweep {

std::string default_table(const std::string& spec) {
  return std::filesystem::path(spec).filename().replace_extension(".h5").string();
}

}  // namespace sigmasweep
