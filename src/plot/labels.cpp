#include "plot/labels.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>

namespace sigmasweep::plot {
namespace {

std::string spaced(std::string_view name) {
  std::string words(name);
  for (char& c : words)
    if (c == '_') c = ' ';
  return words;
}

std::string scientific(double value) {
  std::string text = fmt::format("{:.5e}", value);
  const auto e = text.find('e');
  auto last = text.find_last_not_of('0', e - 1);
  if (text[last] == '.') --last;
  return text.erase(last + 1, e - last - 1);
}

/// An enumerator as people read it in a key.
struct Words {
  std::string_view field, value, words;
};
constexpr auto known_words = std::to_array<Words>({
    {"method", "md", "MD"},
    {"method", "ed", "ED"},
    {"law", "hooke", "Hooke"},
    {"law", "hertz", "Hertz"},
    {"law", "hertz-kuwabara-kono", "Hertz-Kuwabara-Kono"},
    {"law", "taguchi", "Taguchi"},
    {"law", "power", "power law"},
    {"law", "cone", "cones"},
    {"integrator", "exact", "exact"},
    {"integrator", "gear5", "Gear"},
    {"integrator", "verlet", "Verlet"},
    {"integrator", "rk4", "RK4"},
    {"integrator", "leapfrog", "leapfrog"},
    {"geometry", "column", "column"},
    {"geometry", "lattice", "lattice"},
    {"geometry", "vibrated-column", "vibrated column"},
    {"geometry", "vibrated-lattice", "vibrated lattice"},
    {"random_separation", "false", "equal gaps"},
    {"random_separation", "true", "random gaps"},
    {"side_walls", "periodic", "periodic sides"},
    {"side_walls", "fixed", "side walls"},
    {"ed_rule", "lrv", "LRV"},
    {"ed_rule", "tc", "TC"},
});

std::string words_of(std::string_view field, std::string_view value) {
  const auto known = std::ranges::find_if(
      known_words, [&](const Words& words) { return words.field == field && words.value == value; });
  return known == known_words.end() ? fmt::format("{} {}", field, value) : std::string(known->words);
}

}  // namespace

std::string symbol_of(const Field& field) {
  return field.symbol.empty() ? escape_markup(spaced(field.name)) : std::string(field.symbol);
}

std::string escape_markup(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("\\^_@&~{}").find(c) != std::string_view::npos) out += '\\';
    out += std::iscntrl(static_cast<unsigned char>(c)) ? ' ' : c;
  }
  return out;
}

std::string pretty(double value) {
  const bool tiny = value != 0.0 && std::abs(value) < 1e-3;  // where {:g} would still write zeros
  std::string plain = tiny ? scientific(value) : fmt::format("{:.6g}", value);
  const auto e = plain.find('e');
  if (e == std::string::npos) return plain;
  std::string power = fmt::format("10^{{{}}}", std::stoi(plain.substr(e + 1)));
  const std::string mantissa = plain.substr(0, e);
  if (mantissa == "1") return power;
  return mantissa + "×" + power;
}

std::string axis_label(const Field& field) {
  std::string label = field.quantity.empty() ? symbol_of(field) : std::string(field.quantity);
  if (field.unit != "1" && !field.unit.empty()) label += fmt::format(" ({})", escape_markup(field.unit));
  return label;
}

std::string expression_label(std::string_view expression) {
  const auto is_letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  const auto is_part = [&](char c) { return is_letter(c) || c == '.'; };
  std::string out;
  char before = 0;  // the last character that is not a space
  for (std::size_t i = 0; i < expression.size();) {
    const char c = expression[i];
    const bool raised = before == '^';
    if (std::isspace(static_cast<unsigned char>(c))) {
      ++i;
      continue;
    }
    if (is_part(c)) {
      std::size_t end = i;
      while (end < expression.size() && is_part(expression[end])) ++end;
      const std::string word(expression.substr(i, end - i));
      const Field* field = find_field(word);
      const std::string shown = field ? symbol_of(*field) : escape_markup(word);
      out += raised ? "{" + shown + "}" : shown;
      i = end - 1;
    } else if (c == '+' || c == '-') {
      const bool binary = is_part(before) || before == ')';
      const std::string sign = c == '-' ? "−" : "+";
      out += binary ? " " + sign + " " : raised ? "{" + sign + "}" : sign;
    } else if (c == '*') {
      out += "\u2009";  // a thin space
    } else {
      out += c == '^' ? "^" : escape_markup(std::string(1, c));
    }
    before = expression[i++];
  }
  return out;
}

std::string value_label(const Field& field, const Row& row) {
  if (!enumerators(field.type).empty()) return escape_markup(words_of(field.name, text(field, row)));
  std::string label = symbol_of(field) + " = " + pretty(number(field, row));
  if (field.unit != "1" && !field.unit.empty()) label += " " + escape_markup(field.unit);
  return label;
}

std::string panel_title(std::size_t number, const Row& row, std::span<const std::string> differ) {
  std::string words;
  for (const std::string& name : differ)
    if (const Field* field = find_field(name)) words += (words.empty() ? "" : ", ") + value_label(*field, row);
  return fmt::format("({}) {}", static_cast<char>('a' + number), words);
}

}  // namespace sigmasweep::plot
