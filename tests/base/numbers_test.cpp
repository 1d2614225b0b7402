#include "base/text/numbers.hpp"

#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

using namespace sigmasweep;

TEST(Numbers, AreReadToTheBit) {
  EXPECT_EQ(parse_number("0.1"), 0.1);
  EXPECT_EQ(parse_number("+1"), 1.0);
  EXPECT_EQ(parse_number("-1e1"), -10.0);
  EXPECT_EQ(parse_number("1e-310"), 1e-310);  // denormal
  EXPECT_EQ(parse_number("5e-324"), std::numeric_limits<double>::denorm_min());
  for (const char* none : {"", "+", "+-1", "++1", "1x", " 1", "1e", "0x10", "1e999", "1e-999", "2*10^-5"})
    EXPECT_EQ(parse_number(none), std::nullopt) << none;
}

TEST(Numbers, WholeOnesMayHaveAPointOrAnExponent) {
  EXPECT_EQ(parse_whole_number("61"), 61);
  EXPECT_EQ(parse_whole_number("61.0"), 61);
  EXPECT_EQ(parse_whole_number("+61"), 61);
  EXPECT_EQ(parse_whole_number("1e1"), 10);
  EXPECT_EQ(parse_whole_number("-3"), -3);
  EXPECT_EQ(parse_whole_number("9007199254740993"), 9007199254740993);
  EXPECT_EQ(parse_whole_number("9223372036854775807"), std::numeric_limits<std::int64_t>::max());
  for (const char* none : {"", "61.5", "1e-1", "nan", "inf", "1e16", "9223372036854775808", "N"})
    EXPECT_EQ(parse_whole_number(none), std::nullopt) << none;
}

TEST(Numbers, PowersOfTenAreShownAsTheyAreWritten) {
  EXPECT_EQ(number_hint("2*10^-5"), " (write 2e-5)");
  EXPECT_EQ(number_hint("2.5 x 10**6"), " (write 2.5e6)");
  EXPECT_EQ(number_hint("-1·10^{3}"), " (write -1e3)");
  for (const char* other : {"", "2*5", "10^5*2", "1..2*10^3", "N*10^2"}) EXPECT_EQ(number_hint(other), "") << other;
}
