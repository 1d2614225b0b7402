#pragma once

#include <string>
#include <string_view>

namespace sigmasweep::plot {

/// Gnuplot's enhanced text as HTML: italics, subscripts and superscripts; all else is text.
std::string html_of_markup(std::string_view markup);
/// The text with the characters escaped that HTML would take for its own.
std::string escape_html(std::string_view text);

}  // namespace sigmasweep::plot
