#pragma once

#include <string>
#include <string_view>

#include <toml++/toml.h>

#include "sweep/toml/mistakes.hpp"

namespace sigmasweep::spec {

/// The spec as a table. A line with a mistake of syntax is left out, so that the mistakes behind it are found, too.
/// Throws SpecError where no line can be left out.
toml::table parse_toml(std::string_view text, const std::string& file, Mistakes& mistakes);

}  // namespace sigmasweep::spec
