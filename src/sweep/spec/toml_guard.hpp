#pragma once

#include <string>
#include <string_view>

namespace sigmasweep::spec {

/// Largest spec, bytes. A table of numbers belongs in axes, not in lists of a million values.
inline constexpr std::size_t max_text = std::size_t{4} << 20;

/// Refuses, with a SpecError, texts that the TOML library cannot hold safely: larger than max_text, or with keys of so
/// many dotted parts that the recursion over the nested tables would exhaust the stack (it limits only brackets).
void require_parsable(std::string_view text, const std::string& file);

}  // namespace sigmasweep::spec
