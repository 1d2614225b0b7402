#include "sweep/spec/tuples/points.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/spelling.hpp"
#include "base/text/numbers.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep::spec {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == text.npos) return {};
  text = text.substr(first, text.find_last_not_of(blanks) - first + 1);
  if (text.size() > 1 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  return text;
}

/// A line of the points that is neither empty nor a comment.
struct Line {
  toml::source_index number;
  std::vector<std::string_view> cells;
};

std::vector<std::string_view> cells_of(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(separator, begin), line.size());
    cells.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return cells;
}

/// Where points stand: in a file of their own, whose name their first line has, or in the spec.
struct Source {
  std::string file;
  std::string_view text;
  std::optional<toml::source_region> in_spec;  ///< none: a file of their own

  /// "file:line: " of a line of the text, counted from 1.
  std::string where(toml::source_index line) const {
    if (!in_spec) return place(file, line);
    const toml::source_index first = in_spec->begin.line, lines = in_spec->end.line - first;
    if (lines == 0) return fmt::format("{}sweep.points: line {}: ", place(file, first), line);
    const auto ends = static_cast<toml::source_index>(std::ranges::count(text, '\n'));
    return fmt::format("{}sweep.points: ", place(file, first + (lines - ends) + line - 1));
  }
  [[noreturn]] void refuse(toml::source_index line, std::string_view why) const {
    throw SpecError(where(line) + std::string(why));
  }
};

Source source_of(const Entry& entry, std::string_view text) {
  if (!text.starts_with(from_file)) return {*entry.file, text, entry.node->source()};
  const std::size_t end = std::min(text.find('\n'), text.size());
  return {std::string(text.substr(from_file.size(), end - from_file.size())),
          text.substr(std::min(end + 1, text.size())),
          {}};
}

std::vector<Line> lines_of(const Source& source) {
  std::vector<Line> lines;
  std::optional<char> separator;
  toml::source_index number = 0;
  for (std::size_t begin = 0; begin < source.text.size();) {
    const std::size_t end = std::min(source.text.find('\n', begin), source.text.size());
    const std::string_view line = source.text.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    if (trimmed(line).empty() || trimmed(line).front() == '#') continue;
    if (!separator) {
      const std::size_t first = line.find_first_of(",;\t");
      separator = first == line.npos ? ',' : line[first];
    }
    lines.push_back({number, cells_of(line, *separator)});
  }
  return lines;
}

const ParameterField& parameter_of(const Source& source, const Line& header, std::size_t column) {
  const std::string_view name = header.cells[column];
  if (std::ranges::find(header.cells.begin(), header.cells.begin() + static_cast<std::ptrdiff_t>(column), name) !=
      header.cells.begin() + static_cast<std::ptrdiff_t>(column))
    source.refuse(header.number, fmt::format("column {}: '{}' is there twice", column + 1, name));
  if (const ParameterField* field = find_parameter(name)) return *field;
  std::vector<std::string_view> names;
  for (const Field& field : parameter_fields()) names.push_back(field.name);
  const std::string_view why = find_field(name) ? "is a result, no parameter" : "is no parameter";
  source.refuse(header.number, fmt::format("column {}: '{}' {}{}", column + 1, name, why, hint(name, names)));
}

/// The value in a cell as a node of TOML, which is what values are read from.
std::unique_ptr<toml::node> node_of(const ParameterField& field, std::string_view cell) {
  const std::string text(cell);
  if (field.type == FieldType::of<Flag>() && (cell == "true" || cell == "false"))
    return std::make_unique<toml::value<bool>>(cell == "true");
  if (field.type == FieldType::integer)
    if (const auto whole = parse_whole_number(text)) return std::make_unique<toml::value<std::int64_t>>(*whole);
  if (enumerators(field.type).empty())
    if (const auto number = parse_number(text)) return std::make_unique<toml::value<double>>(*number);
  return std::make_unique<toml::value<std::string>>(text);
}

AnyNumber value_of(const Source& source, const Line& line, std::size_t column, const ParameterField& field) {
  const auto node = node_of(field, line.cells[column]);
  try {
    return read_value({.file = &source.file, .path = std::string(field.name), .name = field.name, .node = node.get()},
                      field);
  } catch (const SpecError& error) {
    std::string_view why = error.what();
    why.remove_prefix(std::min(why.size(), source.file.size() + 2));  // "FILE: "
    source.refuse(line.number, fmt::format("column {}, {}", column + 1, why));
  }
}

}  // namespace

std::vector<Setting> read_points(const Entry& entry) {
  const std::string text = as_string(entry);
  if (text.find('\n') == text.npos)
    refuse_value(entry, "must be the name of a file, in a spec that is a file itself; or the points, a line each");
  const Source source = source_of(entry, text);
  const std::vector<Line> lines = lines_of(source);
  if (lines.size() < 2) source.refuse(1, "points are a line with the parameters' names, and at least one of values");
  const Line& header = lines.front();
  for (const Line& line : lines)
    if (line.cells.size() != header.cells.size())
      source.refuse(line.number, fmt::format("{} values under {} names", line.cells.size(), header.cells.size()));
  std::vector<Setting> settings;
  for (std::size_t column = 0; column < header.cells.size(); ++column) {
    const ParameterField& field = parameter_of(source, header, column);
    std::vector<AnyNumber> values;
    for (std::size_t k = 1; k < lines.size(); ++k) values.push_back(value_of(source, lines[k], column, field));
    Entry at = entry;
    at.path += fmt::format(".{}", field.name);
    at.name = field.name;
    settings.push_back({at, &field, Axis::list(std::move(values)), true});
  }
  return settings;
}

}  // namespace sigmasweep::spec
