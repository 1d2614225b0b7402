#pragma once

#include <cstddef>
#include <string_view>

#include <toml++/toml.h>

namespace sigmasweep::spec {

/// The place in the text of a position of the parser, whose columns count characters, not bytes of UTF-8.
std::size_t offset_of(std::string_view text, toml::source_position position);

}  // namespace sigmasweep::spec
