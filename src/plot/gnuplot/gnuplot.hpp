#pragma once

#include <string>
#include <string_view>

/// Gnuplot as a process, and parts of its commands.
namespace sigmasweep::plot {

/// The file format of a picture.
enum class Form { svg, png, pdf };

/// The file format that belongs to the ending of `path`. Throws UsageError for another ending.
Form form_of(const std::string& path);

/// Runs gnuplot on `commands`, without a shell. Its standard output becomes the file `path`, which is complete or not
/// there. Throws OutputError.
void run_gnuplot(const std::string& commands, const std::string& path);

/// Options of gnuplot's terminal for a picture of several panels; width and height in pixels of an SVG.
std::string panels_terminal(Form form, double width, double height);

/// The text as a quoted string of gnuplot. Quotes, backquotes and backslashes are written by their octal numbers:
/// gnuplot stumbles over single quotes at the beginning of a string, and runs what is between backquotes. Control
/// characters become spaces.
std::string quoted(std::string_view text);

/// Enhanced text, which may be a user's, as a string of gnuplot's language. Of the names of fonts, which gnuplot copies
/// into an SVG as they are, only letters, digits and -_.,:=*+ are left.
std::string quoted_markup(std::string_view text);

}  // namespace sigmasweep::plot
