#include "plot/gnuplot/fonts.hpp"

#include <gtest/gtest.h>

namespace sigmasweep::plot {
namespace {

TEST(Fonts, KnowTheLettersOfPlots) {
  const std::string text = "σ = 0.3, ε_{eff} ⟨{/:Italic h}⟩ × 10^{-3} ≤ µs ’";
  const DrawableText drawable = with_installed_fonts(text);
  EXPECT_EQ(drawable.text, text);
  EXPECT_EQ(drawable.missing, "");
}

/// U+F0000 is for private use, and the second string is not UTF-8.
TEST(Fonts, LackWhatNoFontHas) {
  const DrawableText drawable = with_installed_fonts(
      "a\xF3\xB0\x80\x80"
      "b\xF3\xB0\x80\x80");
  EXPECT_EQ(drawable.text, "a?b?");
  EXPECT_EQ(drawable.missing, "\xF3\xB0\x80\x80");
  EXPECT_EQ(with_installed_fonts("a\xFFz").text, "a?z");
}

}  // namespace
}  // namespace sigmasweep::plot
