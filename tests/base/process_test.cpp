#include "base/process.hpp"

#include <gtest/gtest.h>

#include <system_error>

namespace sigmasweep {
namespace {

using std::chrono::seconds;

TEST(Process, GivesTheOutputOfAProgram) {
  EXPECT_EQ(output_of({"printf", "%s-%s", "a b", "$HOME"}, seconds(30)), "a b-$HOME");  // no shell
  EXPECT_EQ(output_of({"true"}, seconds(30)), "");
}

TEST(Process, GivesNothingWhereAProgramFailsOrIsMissing) {
  EXPECT_EQ(output_of({"false"}, seconds(30)), std::nullopt);
  EXPECT_EQ(output_of({"no-such-program-of-sigmasweep"}, seconds(30)), std::nullopt);
}

TEST(Process, KillsAProgramThatTakesTooLong) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(output_of({"sleep", "100"}, std::chrono::milliseconds(200)), std::nullopt);
  EXPECT_LT(std::chrono::steady_clock::now() - start, seconds(50));
  Process program({"sleep", "100"}, {});
  EXPECT_EQ(program.wait_until(std::chrono::steady_clock::now()), -1);
}

TEST(Process, ReturnsTheExitStatus) {
  EXPECT_EQ(Process({"sh", "-c", "exit 7"}, {}).wait(), 7);
  EXPECT_EQ(Process({"sh", "-c", "kill -9 $$"}, {}).wait(), -1);
}

TEST(Process, SaysThatAProgramIsMissing) {
  try {
    const Process program({"no-such-program-of-sigmasweep"}, {});
    FAIL();
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code(), std::errc::no_such_file_or_directory);
  }
}

}  // namespace
}  // namespace sigmasweep
