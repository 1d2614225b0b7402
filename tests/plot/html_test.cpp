// Pages of HTML: markup, and what titles may be. That the page works a browser says:
// tests/cli/html_test.py.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "plot/html/markup.hpp"
#include "plot/html/page.hpp"
#include "support/parameters.hpp"

namespace sigmasweep::plot {
namespace {

TEST(Html, MarkupBecomesTags) {
  EXPECT_EQ(html_of_markup("{/:Italic ε}_{eff}"), "<i>ε</i><sub>eff</sub>");
  EXPECT_EQ(html_of_markup("10^{-6} s"), "10<sup>-6</sup> s");
  EXPECT_EQ(html_of_markup("v_0 = 14"), "v<sub>0</sub> = 14");
  EXPECT_EQ(html_of_markup("a\\_b"), "a_b");
}

TEST(Html, TextIsNeverAnElement) {
  EXPECT_EQ(html_of_markup("<script>alert(1)</script>"), "&lt;script&gt;alert(1)&lt;/script&gt;");
  EXPECT_EQ(html_of_markup("{/:Italic <b>}"), "<i>&lt;b&gt;</i>");
  EXPECT_EQ(html_of_markup("{/<img> x}"), "x");
  EXPECT_EQ(escape_html("\"&'"), "&quot;&amp;&#39;");
  for (const std::string hostile : {"{", "_", "^", "\\", "{/", "{/:Italic", "}{", "_{", "^{}}"})
    html_of_markup(hostile);
}

Row row() {
  Row row;
  row.index = 3;
  row.parameters = completed({.v0 = 1.0, .tc = 1e-5, .s0 = 1e-6});
  row.result.eps_eff = 0.5;
  return row;
}

TEST(Html, ATitleEndsNeitherTitleNorScript) {
  const std::vector<Row> rows{row()};
  PlotSpec spec;
  const std::string title = "</script><script>alert('@DATA@')</script> @TITLE@";
  const std::string page = html_page(figure_of(rows, spec, title), rows, spec);
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_NE(page.find("&lt;script&gt;alert(&#39;@DATA@&#39;)"), std::string::npos);
}

}  // namespace
}  // namespace sigmasweep::plot
