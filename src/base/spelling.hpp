#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace sigmasweep {

/// The known name that `name` was probably meant to be: few edits away (insert, delete, replace, swap; case is free)
/// or a beginning of it.
std::optional<std::string_view> nearest(std::string_view name, std::span<const std::string_view> known);

/// What a message adds for an unknown name: " (did you mean 'x'?)", or where nothing is near "; known: a, b, c".
std::string hint(std::string_view name, std::span<const std::string_view> known);

/// "a", "b" or "c", each in single quotes.
std::string alternatives(std::span<const std::string_view> names);

}  // namespace sigmasweep
