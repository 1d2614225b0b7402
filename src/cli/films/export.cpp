#include "cli/films/export.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "base/atomic_file.hpp"
#include "cli/films/read.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {
namespace {

namespace fs = std::filesystem;

void make_directory(const fs::path& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error || !fs::is_directory(directory))
    throw OutputError(
        fmt::format("cannot create {}: {}", directory.string(), error ? error.message() : "it is a file"));
}

void put_file(const fs::path& path, const std::string& text) {
  make_directory(path.parent_path());
  write_text_file(path.string(), text);
}

}  // namespace

void export_films(const StoredSweep& stored, const std::string& table, const FilmFormat& format,
                  const std::string& directory) {
  if (!stored.sweep) throw UsageError(fmt::format("{} {}", table, why_not_ours(stored)));
  if (!stored.sweep->trajectory())
    throw UsageError(fmt::format("{} has no trajectories: its spec has no table [trajectory]", table));
  make_directory(directory);
  for (const Row& row : filmed_rows(stored))
    format.write(Film({row.index, row.parameters}, read_film(stored, table, row)),
                 [&](const std::string& name, const std::string& text) { put_file(fs::path(directory) / name, text); });
}

}  // namespace sigmasweep
