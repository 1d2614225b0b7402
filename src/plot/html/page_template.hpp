#pragma once

#include <string_view>

namespace sigmasweep::plot {

/// page.html, with the places @TITLE@ and @DATA@.
std::string_view page_template();

}  // namespace sigmasweep::plot
