#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>

#include "base/atomic_file.hpp"
#include "base/output/place.hpp"
#include "cli/command.hpp"
#include "cli/films/export.hpp"
#include "cli/read_sweep.hpp"
#include "sigmasweep/base/errors.hpp"
#include "store/rows/formats.hpp"
#include "store/stored/stored_sweep.hpp"

namespace sigmasweep {
namespace {

struct ExportOptions {
  std::string table, output;
  std::string format;  ///< a name of row_formats(); empty: from the ending of `output`
  std::string films;   ///< a name of film_formats(); empty: rows
  bool timings = false;
};

RowFormat chosen_format(const ExportOptions& options) {
  if (!options.format.empty()) return row_format(options.format).value();
  const std::string ending = std::filesystem::path(options.output).extension().string();
  return row_format(ending.empty() ? ending : ending.substr(1)).value_or(row_formats().front());
}

/// Writes rows to a file. Errors are kept in the file's error indicator.
void write(std::FILE* file, RowWriter& writer, const std::vector<Row>& rows) {
  const auto put = [file](const std::string& text) { std::fwrite(text.data(), 1, text.size(), file); };
  put(writer.head());
  for (const Row& row : rows) put(writer.record(row));
  put(writer.tail());
}

/// The same for a file or a stream that is open. Throws IoError.
void write_to(const File& open, const std::string& path, RowWriter& writer, const std::vector<Row>& rows) {
  std::FILE* file = ::fdopen(::dup(open.fd()), "wb");
  if (file == nullptr) throw OutputError(fmt::format("cannot write {}: {}", path, reason(errno)));
  write(file, writer, rows);
  const bool written = std::fflush(file) == 0 && std::ferror(file) == 0;
  if (std::fclose(file) != 0 || !written) throw IoError(fmt::format("cannot write {}", path));
}

int export_motion(const ExportOptions& options) {
  if (options.output.empty() || options.output == "-") throw UsageError("--films needs a directory: -o DIR");
  if (options.timings || !options.format.empty()) throw UsageError("--films: --format and --timings are for rows");
  export_films(read_sweep(options.table), options.table, film_format(options.films).value(), options.output);
  return 0;
}

int export_table(const ExportOptions& options) {
  if (!options.films.empty()) return export_motion(options);
  require_other_file(options.output, std::array{options.table, beside(options.table, ".journal")});
  const StoredSweep stored = read_sweep(options.table);
  std::vector<Field> columns = stored.table.columns;
  if (options.timings) columns.insert(columns.end(), timing_fields().begin(), timing_fields().end());
  const auto writer = chosen_format(options).writer(std::move(columns));
  const auto& rows = stored.table.rows;
  if (options.output.empty() || options.output == "-") {
    write(stdout, *writer, rows);
  } else if (const auto stream = open_stream(options.output)) {
    write_to(*stream, options.output, *writer, rows);
  } else {
    AtomicFile output(options.output);
    write_to(File(output.part(), O_WRONLY | O_NOFOLLOW), options.output, *writer, rows);
    output.publish();
  }
  return 0;
}

void declare(OptionSet& set, ExportOptions& options) {
  std::vector<std::string> formats;
  for (const RowFormat& format : row_formats()) formats.emplace_back(format.name);
  const std::string names = fmt::format("{}", fmt::join(formats, "|"));
  set.add({"table", "A table that 'run' wrote, or will write", "TABLE.h5"}, options.table);
  set.add({"-o,--output", "The file, device or pipe; default and -: standard output", "FILE." + names}, options.output);
  set.add({"--format", fmt::format("Format of the rows; default: from the file's ending, else {}", formats.front()),
           names, formats},
          options.format);
  std::vector<std::string> films;
  for (const FilmFormat& format : film_formats()) films.emplace_back(format.name);
  set.add({"--films", "Write the trajectories instead, for viewers, into a directory -o",
           fmt::format("{}", fmt::join(films, "|")), films},
          options.films);
  set.add_flag("--timings", "Add the columns run time, predicted time, rank and attempt", options.timings);
}

}  // namespace

Command export_command() {
  std::string footer;
  for (const RowFormat& format : row_formats()) footer += fmt::format("\n{:<6} {}", format.name, format.meaning);
  footer += "\n\nFormats of films:";
  for (const FilmFormat& format : film_formats()) footer += fmt::format("\n{:<6} {}", format.name, format.meaning);
  return make_command("export", "Write a table, or its trajectories, as text", footer, declare, export_table);
}

}  // namespace sigmasweep
