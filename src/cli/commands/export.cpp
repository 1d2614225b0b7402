#include <fmt/format.h>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "cli/commands.hpp"
#include "engine/ledger/stored_sweep.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {
namespace {

/// A value as RFC 4180 wants it: in quotes where it has a comma, a quote or the end of a line.
std::string csv(std::string_view value) {
  if (value.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(value);
  std::string quoted = "\"";
  for (const char c : value) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

void write_csv(std::FILE* file, const std::vector<Field>& columns, const std::vector<Row>& rows) {
  const auto write_record = [&](auto value_of) {
    std::string record;
    for (const Field& field : columns) record += (record.empty() ? "" : ",") + csv(value_of(field));
    record += "\r\n";
    std::fwrite(record.data(), 1, record.size(), file);  // errors stay with the file and are asked for at the end
  };
  write_record([](const Field& field) { return field.name; });
  for (const Row& row : rows) write_record([&](const Field& field) { return text(field, row); });
}

}  // namespace

int export_csv(const ExportOptions& options) {
  const StoredSweep stored = read_stored_sweep(options.table);
  std::vector<Field> columns = stored.table.columns;
  if (options.timings) columns.insert(columns.end(), timing_fields().begin(), timing_fields().end());
  if (options.output.empty()) {
    write_csv(stdout, columns, stored.table.rows);
    return 0;
  }
  const std::string part = options.output + ".part";  // complete or not there
  std::FILE* file = std::fopen(part.c_str(), "wb");
  if (file == nullptr) throw OutputError(fmt::format("cannot create {}: {}", options.output, std::strerror(errno)));
  write_csv(file, columns, stored.table.rows);
  const bool written = std::fflush(file) == 0 && std::ferror(file) == 0;
  if (std::fclose(file) != 0 || !written) {
    std::remove(part.c_str());
    throw IoError(fmt::format("cannot write {}", options.output));
  }
  std::error_code error;
  std::filesystem::rename(part, options.output, error);
  if (error) {
    std::remove(part.c_str());
    throw OutputError(fmt::format("cannot create {}: {}", options.output, error.message()));
  }
  return 0;
}

}  // namespace sigmasweep
