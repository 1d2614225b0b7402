#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <span>

#include "base/file.hpp"
#include "cli/command.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/geometry.hpp"
#include "sweep/reference/blank_spec.hpp"

namespace sigmasweep {
namespace {

struct NewOptions {
  std::string geometry, output;
};

int write_spec(const NewOptions& options) {
  const auto geometry = value_named<Geometry>(options.geometry).value();
  const bool to_stdout = options.output.empty() || options.output == "-";
  const std::string name = to_stdout ? "beads" : std::filesystem::path(options.output).stem().string();
  const std::string text = blank_spec(geometry, name);
  if (to_stdout) {
    fmt::print("{}", text);
    return 0;
  }
  const File file(options.output, O_WRONLY | O_CREAT | O_EXCL);
  if (!file.is_open()) throw OutputError(fmt::format("cannot make {}: {}", options.output, reason(errno)));
  if (const int error = write_all(file.fd(), std::as_bytes(std::span(text))); error != 0)
    throw IoError(fmt::format("cannot write {}: {}", options.output, reason(error)));
  return 0;
}

void declare(OptionSet& set, NewOptions& options) {
  const auto names = names_of<Geometry>();
  set.add({"geometry", "The geometry of the sweep", "GEOMETRY", {names.begin(), names.end()}}, options.geometry);
  set.add({"-o,--output", "The spec, which must not exist yet; default: standard output", "FILE.toml"}, options.output);
}

}  // namespace

Command new_command() {
  return make_command("new", "Write a spec to begin with: a small sweep, and all keys in comments",
                      "\n  sigmasweep new column -o beads.toml && sigmasweep plan beads.toml", declare, write_spec);
}

}  // namespace sigmasweep
