#pragma once

#include <string>
#include <string_view>

namespace sigmasweep {

/// UTF-8 text of somebody else's for a terminal. Control characters, which terminals obey, become spaces; line feeds
/// stay.
std::string printable(std::string_view text);

}  // namespace sigmasweep
