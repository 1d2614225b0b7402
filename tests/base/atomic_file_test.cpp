#include "base/atomic_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {
namespace {

namespace fs = std::filesystem;

class AtomicFiles : public testing::Test {
 protected:
  AtomicFiles() { fs::create_directory(directory_); }
  ~AtomicFiles() override { fs::remove_all(directory_); }

  static std::span<const std::byte> bytes(std::string_view text) { return std::as_bytes(std::span(text)); }
  std::string content() const {
    std::ifstream file(path_);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  const fs::path directory_ = fs::temp_directory_path() / ("sigmasweep-atomic-file-" + std::to_string(::getpid()));
  const std::string path_ = (directory_ / "file").string();
};

TEST_F(AtomicFiles, KeepTheOlderFileUntilTheyArePublished) {
  write_whole_file(path_, bytes("old"));
  {
    AtomicFile file(path_);
    ASSERT_EQ(write_at(file.fd(), bytes("new"), 0), 0);
    EXPECT_EQ(content(), "old");
    EXPECT_TRUE(fs::exists(path_ + ".part"));
    file.publish();
    EXPECT_EQ(content(), "new");
  }
  EXPECT_EQ(content(), "new");
  EXPECT_FALSE(fs::exists(path_ + ".part"));
}

TEST_F(AtomicFiles, LeaveNothingBehindIfTheyAreNotPublished) {
  write_whole_file(path_, bytes("old"));
  {
    AtomicFile file(path_, ".draft");
    ASSERT_EQ(write_at(file.fd(), bytes("half"), 0), 0);
    EXPECT_EQ(file.part(), path_ + ".draft");
  }
  EXPECT_EQ(content(), "old");
  EXPECT_FALSE(fs::exists(path_ + ".draft"));
}

TEST_F(AtomicFiles, SayWhichFileCannotBeCreated) {
  const std::string nowhere = (directory_ / "no" / "file").string();
  try {
    const AtomicFile file(nowhere);
    FAIL();
  } catch (const OutputError& error) {
    EXPECT_EQ(error.what(), "cannot create " + nowhere + ": No such file or directory");
  }
  fs::create_directory(path_);  // a directory cannot be replaced by a file
  EXPECT_THROW(write_whole_file(path_, bytes("text")), OutputError);
  EXPECT_FALSE(fs::exists(path_ + ".part"));
}

TEST_F(AtomicFiles, ReleaseTheOpenFile) {
  AtomicFile atomic(path_);
  atomic.publish();
  const File file = atomic.release();
  ASSERT_EQ(write_at(file.fd(), bytes("later"), 0), 0);
  EXPECT_EQ(content(), "later");
}

}  // namespace
}  // namespace sigmasweep
