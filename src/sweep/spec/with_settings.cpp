#include "sweep/spec/with_settings.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "base/text/numbers.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sweep/toml/place_in_text.hpp"
#include "sweep/toml/sweep_tables.hpp"
#include "sweep/toml/toml_guard.hpp"

namespace sigmasweep::spec {
namespace {

/// The text of a value alone, without the comment behind it; nothing if it is not a value of TOML.
std::optional<std::string> value_in(const std::string& typed) {
  const std::string line = "v = " + typed;
  try {
    require_parsable(line, "");
    const toml::table table = toml::parse(line);
    if (table.size() != 1) return std::nullopt;
    const toml::source_region place = table.begin()->second.source();
    const std::size_t begin = offset_of(line, place.begin);
    return line.substr(begin, offset_of(line, place.end) - begin);
  } catch (const toml::parse_error&) {
    return std::nullopt;
  } catch (const SpecError&) {
    return std::nullopt;
  }
}

/// The first token of a text that is not empty: a string, a word or number, or another character.
std::string_view first_token(std::string_view text) {
  if (text[0] == '"' || text[0] == '\'') return text.substr(0, std::min(text.find(text[0], 1), text.size() - 1) + 1);
  const auto in_token = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.' || c == '+';
  };
  const auto end = std::ranges::find_if_not(text, in_token);
  return text.substr(0, std::max<std::size_t>(1, static_cast<std::size_t>(end - text.begin())));
}

bool is_name(std::string_view token) {
  constexpr std::array<std::string_view, 4> values{"true", "false", "inf", "nan"};
  const auto in_name = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
  return std::isalpha(static_cast<unsigned char>(token[0])) != 0 && std::ranges::all_of(token, in_name) &&
         std::ranges::find(values, token) == values.end();
}

/// The names of a value in quotes: [md, ed] -> ["md", "ed"]. Keys of an inline table are followed by '='.
std::string with_names_quoted(std::string_view typed) {
  std::string quoted;
  while (!typed.empty()) {
    const std::string_view token = first_token(typed);
    typed.remove_prefix(token.size());
    const std::size_t next = typed.find_first_not_of(" \t");
    const bool is_key = next != typed.npos && typed[next] == '=';
    quoted += is_name(token) && !is_key ? fmt::format("\"{}\"", token) : std::string(token);
  }
  return quoted;
}

struct Setting {
  std::string key, value;
};

Setting read(const std::string& typed) {
  const std::size_t equals = std::min(typed.find('='), typed.size());
  const std::string key = typed.substr(0, equals);
  const auto in_key = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  if (equals == typed.size() || key.empty() || !std::ranges::all_of(key, in_key))
    throw UsageError(fmt::format("--set {}: give KEY=VALUE, such as --set N=20", typed));
  const std::string value = typed.substr(equals + 1);
  std::optional<std::string> found = value_in(value);
  if (!found) found = value_in(with_names_quoted(value));
  if (!found && key == "where") found = value_in(fmt::format("'{}'", value));
  if (found) return {key, *found};
  throw UsageError(fmt::format("--set {}: '{}' is not a value in TOML{}", typed, value, number_hint(value)));
}

/// One past the end of the line that a place is on.
std::size_t behind_line(std::string_view text, std::size_t at) { return std::min(text.find('\n', at), text.size()); }

/// Where the last key of [sweep] ends; the end of the header if there is none.
toml::source_position end_of_keys(const toml::table& sweep) {
  toml::source_position end = sweep.source().end;
  for (auto&& [key, node] : sweep)
    if (!node.is_table() || node.as_table()->is_inline()) end = std::max(end, node.source().end);
  return end;
}

/// Adds a key behind the others of [sweep], which is a table with a header, an inline table, or made of dotted keys.
void add(std::string& text, const toml::table& sweep, const Setting& setting) {
  const std::string line = fmt::format("{} = {}", setting.key, setting.value);
  const std::size_t begin = offset_of(text, sweep.source().begin);
  if (text.substr(begin, 7) == "[sweep." || text.substr(begin, 8) == "[ sweep.") {  // only tables below it have headers
    text += fmt::format("\n[sweep]\n{}\n", line);
    return;
  }
  if (sweep.is_inline()) {
    text.insert(offset_of(text, sweep.source().end) - 1, (sweep.empty() ? "" : ", ") + line);
    return;
  }
  const bool has_header = text[begin] == '[';
  text.insert(behind_line(text, offset_of(text, end_of_keys(sweep))), (has_header ? "\n" : "\nsweep.") + line);
}

void replace(std::string& text, const toml::node& node, const Setting& setting) {
  if (node.is_table() && !node.as_table()->is_inline())
    throw UsageError(fmt::format("--set {}: the spec gives {} in several lines; write it as one value there",
                                 setting.key, setting.key));
  const std::size_t begin = offset_of(text, node.source().begin);
  text.replace(begin, offset_of(text, node.source().end) - begin, setting.value);
}

/// Sets a key in [defaults] and in each [sweep] that has it; where none has it, in each [sweep]. Also in each with
/// points, which refuse it if they give it.
void set(std::string& text, const Setting& setting) {
  const toml::table spec = toml::parse(text);
  std::vector<const toml::table*> tables = sweep_tables(spec);
  std::ranges::sort(tables, std::greater<>(), [](const toml::table* table) {  // what is before a change stays in place
    return std::pair(table->source().begin.line, table->source().begin.column);
  });
  const auto has = [&](const toml::table* table) { return table->contains(setting.key); };
  const bool is_there = std::ranges::any_of(tables, has);
  for (const toml::table* table : tables) {
    if (has(table)) replace(text, *table->get(setting.key), setting);
    const bool is_part = table != spec["defaults"].as_table();
    if (is_part && !has(table) && (!is_there || table->contains("points"))) add(text, *table, setting);
  }
}

}  // namespace

std::string with_settings(std::string_view text, std::span<const std::string> settings) {
  std::string changed(text);
  std::string notes;
  for (const std::string& typed : settings) {
    const Setting setting = read(typed);
    try {
      require_parsable(changed, "");
      set(changed, setting);
    } catch (const SpecError&) {
      return std::string(text);
    } catch (const toml::parse_error&) {
      return std::string(text);
    }
    std::string value = setting.value;
    std::ranges::replace(value, '\n', ' ');
    notes += fmt::format("# set on the command line: {} = {}\n", setting.key, value);
  }
  if (!notes.empty() && !changed.empty() && changed.back() != '\n') changed += '\n';
  return changed + notes;
}

}  // namespace sigmasweep::spec
