#include "base/text/numbers.hpp"

#include <charconv>
#include <cmath>
#include <regex>

namespace sigmasweep {
namespace {

constexpr double largest_whole = 0x1p53;  // doubles represent all whole numbers up to this one

/// The whole text as a number. std::from_chars takes no plus sign.
template <class Number>
std::optional<Number> parse(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  Number number{};
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || rest != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) { return parse<double>(text); }

std::optional<std::int64_t> parse_whole_number(std::string_view text) {
  if (const auto digits = parse<std::int64_t>(text)) return digits;
  const auto number = parse<double>(text);
  return number ? whole_number(*number) : std::nullopt;
}

/// MANTISSA*10^EXPONENT, also with ** or a sign of multiplication.
std::string number_hint(std::string_view text) {
  constexpr std::size_t longest = 64;
  if (text.size() > longest) return {};
  static const std::regex power(
      R"(\s*([-+]?[0-9.]+)\s*(?:\*|x|×|·)\s*10\s*(?:\^|\*\*)\s*[({]?\s*([-+]?[0-9]+)\s*[)}]?\s*)");
  std::match_results<std::string_view::const_iterator> parts;
  if (!std::regex_match(text.begin(), text.end(), parts, power)) return {};
  const std::string number = parts[1].str() + "e" + parts[2].str();
  return parse_number(number) ? " (write " + number + ")" : "";
}

std::optional<std::int64_t> whole_number(double value) {
  if (!(std::abs(value) <= largest_whole) || std::floor(value) != value) return std::nullopt;
  return static_cast<std::int64_t>(value);
}

}  // namespace sigmasweep
