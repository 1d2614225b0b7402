#include "engine/run_options.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {

namespace fs = std::filesystem;

std::string default_table(const std::string& spec) {
  const fs::path name = fs::path(spec).filename();
  return (name.extension() == ".toml" ? name.stem() : name).string() + ".h5";
}

void require_named_spec(const std::string& spec) {
  if (spec == "-" || (fs::exists(spec) && !fs::is_regular_file(spec)))
    throw UsageError(fmt::format("a spec that comes from {} needs the table's name: -o TABLE.h5",
                                 spec == "-" ? "standard input" : spec));
}

std::string named_after(const std::string& table, const std::string& ending) {
  const fs::path path(table);
  const bool has_ending = path.extension() == ".h5" || path.extension() == ".hdf5";
  return (has_ending ? path.parent_path() / path.stem() : path).string() + ending;
}

}  // namespace sigmasweep
