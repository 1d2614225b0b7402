#pragma once

#include <string>
#include <string_view>

namespace sigmasweep::plot {

/// UTF-8 text that can be drawn with the fonts that are installed.
struct DrawableText {
  std::string text;     ///< a question mark stands for each character that no font has
  std::string missing;  ///< these characters, each once
};

/// Asks fontconfig. Gnuplot's bitmaps and PDFs show black shapes for characters that no font has.
DrawableText with_installed_fonts(std::string_view text);

}  // namespace sigmasweep::plot
