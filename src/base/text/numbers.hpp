#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Numbers as people type them, with or without a sign: 61, +61, 61.0, 1e1, 1e-310.
namespace sigmasweep {

/// Nothing for a text that is not a number, or that is too large or too small for a double.
std::optional<double> parse_number(std::string_view text);

/// Nothing for a text that is not a whole number. Digits alone are read to the bit. With a point or an exponent at most
/// 2^53, as doubles beyond are not the number that was typed.
std::optional<std::int64_t> parse_whole_number(std::string_view text);

/// A double that is a whole number, of at most 2^53; otherwise nothing.
std::optional<std::int64_t> whole_number(double value);

/// For a message about a text that is no number: " (write 2e-5)" for 2*10^-5, otherwise nothing.
std::string number_hint(std::string_view text);

}  // namespace sigmasweep
