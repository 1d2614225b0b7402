#include "sweep/toml/parse_toml.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "base/text/numbers.hpp"
#include "sweep/spec/entry.hpp"
#include "sweep/toml/toml_guard.hpp"

namespace sigmasweep::spec {
namespace {

constexpr int most_mistakes = 20;
constexpr std::size_t longest_word = 64;

/// The place of a line, from 1, in a text, without its end.
struct Line {
  std::size_t begin = 0, size = 0;
};
Line line_of(std::string_view text, std::size_t number) {
  std::size_t begin = 0;
  for (; number > 1; --number) begin = std::min(text.find('\n', begin), text.size() - 1) + 1;
  return {begin, std::min(text.find('\n', begin), text.size()) - begin};
}

/// The value around a place of a line: between =, commas and brackets.
std::string_view value_at(std::string_view line, std::size_t place) {
  constexpr std::string_view ends = "=,[]{}#";
  place = std::min(place, line.size());
  const std::size_t before = place == 0 ? line.npos : line.find_last_of(ends, place - 1);
  std::string_view value = line.substr(before == line.npos ? 0 : before + 1);
  value = value.substr(0, value.find_first_of(ends));
  const auto is_space = [](unsigned char c) { return std::isspace(c) != 0; };
  while (!value.empty() && is_space(value.front())) value.remove_prefix(1);
  while (!value.empty() && is_space(value.back())) value.remove_suffix(1);
  return value;
}

/// The form that TOML wants for a value that it does not take: a number, or a name without quotes.
std::string hint_for(std::string_view value) {
  if (value.empty() || value.size() > longest_word) return {};
  if (const std::string number = number_hint(value); !number.empty()) return number;
  if (const auto number = parse_number(value)) return fmt::format(" (write {})", *number);
  const auto in_name = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; };
  const bool is_name = std::isalpha(static_cast<unsigned char>(value[0])) != 0 && std::ranges::all_of(value, in_name);
  return is_name ? fmt::format(" (names need quotes: \"{}\")", value) : "";
}

/// Whether the parser goes on behind this line if it is left out: a key with a value that ends on the line.
bool can_be_left_out(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  if (first == line.npos || line[first] == '[' || line.find('=') == line.npos) return false;
  const auto count = [&](char c) { return std::ranges::count(line, c); };
  return count('[') == count(']') && count('{') == count('}') && count('"') % 2 == 0 && count('\'') % 2 == 0;
}

}  // namespace

toml::table parse_toml(std::string_view text, const std::string& file, Mistakes& mistakes) {
  require_parsable(text, file);
  std::string rest(text);
  for (int mistake = 0; mistake < most_mistakes; ++mistake) {
    try {
      return toml::parse(rest, std::string_view(file));
    } catch (const toml::parse_error& error) {
      const toml::source_position at = error.source().begin;
      const Line place_of_line = line_of(rest, at.line);
      const std::string_view line = std::string_view(rest).substr(place_of_line.begin, place_of_line.size);
      mistakes.add(fmt::format("{}{}{}", place(file, at.line), error.description(),
                               hint_for(value_at(line, at.column == 0 ? 0 : at.column - 1))));
      if (at.line == 0 || !can_be_left_out(line)) break;
      rest.replace(place_of_line.begin, place_of_line.size, place_of_line.size, ' ');
    }
  }
  mistakes.refuse_any(Mistakes::readable);
  return {};
}

}  // namespace sigmasweep::spec
