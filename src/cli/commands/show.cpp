#include <fmt/format.h>
#include <unistd.h>
#include <algorithm>
#include <cmath>

#include "base/printable.hpp"
#include "base/spelling.hpp"
#include "cli/command.hpp"
#include "cli/read_sweep.hpp"
#include "sigmasweep/base/errors.hpp"
#include "store/rows/json.hpp"
#include "store/stored/stored_sweep.hpp"
#include "sweep/expression/where.hpp"
#include "sweep/repeat_command.hpp"

namespace sigmasweep {
namespace {

struct ShowOptions {
  std::string table, where;
  std::vector<std::string> fields;  ///< empty: all columns
  std::string sort;                 ///< a field, after '-' from the largest value down; empty: the order of the rows
  bool failed = false, json = false, spec = false;
  std::optional<std::uint64_t> limit;  ///< number of rows shown; 0: all; not given: default_limit, with json all
  static constexpr std::uint64_t default_limit = 40;
};

/// The text of a value, with real numbers rounded to fit a column.
std::string cell(const Field& field, const Row& row) {
  if (field.type != FieldType::real) return text(field, row);
  if (field.name == "eps_eff") return fmt::format("{:.12g}", number(field, row));
  if (field.name.ends_with("_error")) return fmt::format("{:.1e}", number(field, row));
  return fmt::format("{:.6g}", number(field, row));
}

void print_columns(const std::vector<Field>& fields, const std::vector<const Row*>& rows, bool with_command) {
  std::vector<std::vector<std::string>> lines(2);
  lines[0].emplace_back("row");
  lines[1].emplace_back("");
  for (const Field& field : fields) {
    lines[0].emplace_back(field.name);
    lines[1].emplace_back(field.unit == "1" ? "" : field.unit);
  }
  for (const Row* row : rows) {
    auto& line = lines.emplace_back(std::vector{fmt::format("{}", row->index)});
    for (const Field& field : fields) line.push_back(cell(field, *row));
  }
  std::vector<std::size_t> widths(fields.size() + 1);
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  for (std::size_t k = 0; k < lines.size(); ++k) {
    std::string out;
    for (std::size_t i = 0; i < widths.size(); ++i)
      out += fmt::format("{}{:>{}}", i ? "  " : "", lines[k][i], widths[i]);
    fmt::print("{}\n", out);
    if (with_command && k >= 2) fmt::print("  {}\n", repeat_command(rows[k - 2]->parameters));
  }
}

std::string slice_line(const Slice& slice) {
  if (slice.is_whole()) return {};
  return fmt::format("Slice {} of {} (0 to {}): 'sigmasweep merge' joins them.\n", slice.index, slice.count,
                     slice.count - 1);
}

void print_text(const StoredSweep& stored, const ShowOptions& options, const std::vector<const Row*>& rows,
                std::size_t matching) {
  const Table& table = stored.table;
  const std::string of = stored.complete ? "" : fmt::format(" of {}", stored.total);
  const std::string counts = table.rows.empty() ? "" : fmt::format(" ({})", rows_by_status(table.rows));
  fmt::print("{}\n{}: {}{} rows{}, spec {:016x}, {} on {}, {} {}\n{}\n", printable(table.info.title), options.table,
             table.rows.size(), of, counts, table.info.spec_hash, printable(table.info.start),
             printable(table.info.host), table.info.ranks, table.info.ranks == 1 ? "rank" : "ranks",
             slice_line(table.info.slice));
  if (rows.empty()) {
    fmt::print("{}\n", table.rows.empty() ? "no row yet" : "no such rows");
    return;
  }
  print_columns(table.columns, rows, options.failed);
  if (matching > rows.size()) fmt::print("... {} more (--limit 0 shows all, --where some)\n", matching - rows.size());
}

void print_json(const StoredSweep& stored, const ShowOptions& options, const std::vector<const Row*>& rows,
                std::size_t matching) {
  const Table& table = stored.table;
  nlohmann::ordered_json document = {
      {"title", table.info.title}, {"spec_hash", fmt::format("{:016x}", table.info.spec_hash)},
      {"start", table.info.start}, {"host", table.info.host},
      {"ranks", table.info.ranks}, {"complete", stored.complete},
      {"rows", stored.total},      {"done", table.rows.size()},
      {"matching", matching},      {"results", nlohmann::ordered_json::array()}};
  if (!table.info.slice.is_whole())
    document["slice"] = {{"index", table.info.slice.index}, {"count", table.info.slice.count}};
  for (const Row* row : rows) {
    nlohmann::ordered_json result = {{"row", row->index}};
    result.update(json_of(table.columns, *row));
    result.update(json_of(timing_fields(), *row));
    if (options.failed) result["repeat"] = repeat_command(row->parameters);
    document["results"].push_back(std::move(result));
  }
  // Bytes of the title that are not UTF-8 are replaced.
  fmt::print("{}\n", document.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

/// The field of this name. Throws UsageError with the nearest known name.
const Field& field_named(const std::string& name) {
  if (const Field* field = find_field(name)) return *field;
  throw UsageError(fmt::format("'{}' is no field of a row{}", name, hint(name, field_names())));
}

std::vector<Field> chosen(const std::vector<std::string>& names) {
  std::vector<Field> fields;
  for (const std::string& name : names) fields.push_back(field_named(name));
  return fields;
}

/// Sorts rows by a field; rows without a value come last. Rows of equal values keep their order.
void sort_by(const std::string& order, std::vector<const Row*>& rows) {
  const bool falling = order.starts_with('-');
  const Field& field = field_named(falling ? order.substr(1) : order);
  std::ranges::stable_sort(rows, [&](const Row* a, const Row* b) {
    const double x = number(field, *a), y = number(field, *b);
    if (std::isnan(x) || std::isnan(y)) return !std::isnan(x) && std::isnan(y);
    return falling ? x > y : x < y;
  });
}

int show(const ShowOptions& options) {
  const std::vector<Field> fields = all_fields();
  std::optional<Where> where;
  if (!options.where.empty()) where.emplace(options.where, fields);
  const std::vector<Field> wanted = chosen(options.fields);
  if (!options.sort.empty()) field_named(options.sort.substr(options.sort.starts_with('-')));
  StoredSweep stored = read_sweep(options.table);
  if (options.spec) {
    const std::string& text = stored.table.info.spec_text;
    fmt::print("{}", ::isatty(STDOUT_FILENO) != 0 ? printable(text) : text);
    return 0;
  }
  if (!wanted.empty()) stored.table.columns = wanted;
  const std::uint64_t limit = options.limit.value_or(options.json ? 0 : ShowOptions::default_limit);
  std::vector<const Row*> rows;
  for (const Row& row : stored.table.rows) {
    if ((options.failed && is_success(row.result.status)) || (where && !(*where)(row))) continue;
    rows.push_back(&row);
  }
  const std::size_t matching = rows.size();
  if (!options.sort.empty()) sort_by(options.sort, rows);
  if (limit != 0 && rows.size() > limit) rows.resize(limit);
  if (options.json)
    print_json(stored, options, rows, matching);
  else
    print_text(stored, options, rows, matching);
  return 0;
}

void declare(OptionSet& set, ShowOptions& options) {
  set.add({"table", "A table that 'run' wrote, or will write", "TABLE.h5"}, options.table);
  set.add({"--where", "Only rows that satisfy this condition, written as in a spec", "CONDITION"}, options.where);
  set.add({"--fields", "Columns: parameters, results or timings", "FIELD,FIELD..."}, options.fields,
          Several::comma_separated);
  set.add({"--sort", "Order by this field; -FIELD: from the largest value down", "FIELD"}, options.sort);
  set.add_flag("--spec", "The spec that the table was made from", options.spec);
  set.add_flag("--failed", "Only failed rows, each with the command that repeats it", options.failed);
  set.add(
      {"--limit",
       fmt::format("Largest number of rows, 0: all; default {}, with --json all", ShowOptions::default_limit), "ROWS"},
      options.limit, {0, std::int64_t{1} << 40});
  set.add_flag("--json", "One JSON document", options.json);
}

}  // namespace

Command show_command() {
  return make_command("show", "Print rows of a table",
                      "\n  sigmasweep show fig2a.h5 --where \"method == md && sigma > 1 && eps_eff < 0.5\" --limit 10",
                      declare, show);
}

}  // namespace sigmasweep
