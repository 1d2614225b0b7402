#pragma once

#include <string>
#include <string_view>

/// Gnuplot as a process, and the beginnings of its commands.
namespace sigmasweep::plot {

/// The file format of a picture.
enum class Form { svg, png, pdf };

/// The form that the ending of `path` asks for. Throws UsageError.
Form form_of(const std::string& path);

/// Runs gnuplot, without a shell, on `script`; its standard output becomes `path`, complete or not at all.
/// Throws OutputError.
void run_gnuplot(const std::string& script, const std::string& path);

/// The terminal of a picture of several panels, its size in pixels of an SVG.
std::string panels_terminal(Form form, double width, double height);

/// Text as a string of gnuplot's language.
std::string quoted(std::string_view text);

}  // namespace sigmasweep::plot
