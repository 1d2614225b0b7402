#include "base/printable.hpp"

#include <gtest/gtest.h>

namespace sigmasweep {
namespace {

TEST(Printable, ControlCharactersBecomeSpaces) {
  EXPECT_EQ(printable("\x1b]0;title\x07\x1b[31mred\x7f\r\tend"), " ]0;title  [31mred   end");
  EXPECT_EQ(printable("C1: \xC2\x9B"
                      "31m"),
            "C1:  31m");
}

TEST(Printable, TextsStay) { EXPECT_EQ(printable("ε = 0.9, v₀, £ 3,\nline two"), "ε = 0.9, v₀, £ 3,\nline two"); }

}  // namespace
}  // namespace sigmasweep
