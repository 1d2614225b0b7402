#pragma once

#include <string>
#include <string_view>

namespace sigmasweep::spec {

/// Largest size of a spec, bytes.
inline constexpr std::size_t max_text = std::size_t{4} << 20;

/// Refuses, with a SpecError, a text that the TOML library cannot read safely: larger than max_text, or with a key of
/// so many dotted parts that the recursion over nested tables exhausts the stack (the library limits brackets only).
void require_parsable(std::string_view text, const std::string& file);

}  // namespace sigmasweep::spec
