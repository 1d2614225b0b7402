#include "base/output/place.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/atomic_file.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {
namespace {

namespace fs = std::filesystem;

class OutputPlaces : public testing::Test {
 protected:
  OutputPlaces() { fs::create_directory(directory_); }
  ~OutputPlaces() override { fs::remove_all(directory_); }

  std::string name(const std::string& file) const { return (directory_ / file).string(); }
  static std::span<const std::byte> bytes(std::string_view text) { return std::as_bytes(std::span(text)); }
  static std::string content(const std::string& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  const fs::path directory_ = fs::temp_directory_path() / ("sigmasweep-output-place-" + std::to_string(::getpid()));
};

TEST_F(OutputPlaces, LinksStandForTheirTargets) {
  fs::create_directory(name("far"));
  fs::create_symlink("far/file", name("one"));
  fs::create_symlink("one", name("two"));
  EXPECT_EQ(linked_file(name("two")), name("far/file"));  // which is not there
  EXPECT_EQ(beside(name("two"), ".journal"), name("far/file.journal"));
  EXPECT_EQ(linked_file("plain"), "plain");
  fs::create_symlink("round", name("round"));
  EXPECT_THROW(write_whole_file(name("round"), bytes("text")), OutputError);
  write_whole_file(name("two"), bytes("text"));
  EXPECT_EQ(content(name("far/file")), "text");
  EXPECT_TRUE(fs::is_symlink(name("two")));
}

TEST_F(OutputPlaces, StreamsAreWrittenToAtTheEnd) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe2(ends.data(), O_NONBLOCK), 0);
  const File reading(ends[0]), writing(ends[1]);
  std::array<char, 8> got{};
  const std::string path = "/dev/fd/" + std::to_string(writing.fd());
  {
    const AtomicFile file(path);
    ASSERT_EQ(write_at(file.fd(), bytes("half"), 0), 0);
  }
  EXPECT_LT(::read(reading.fd(), got.data(), got.size()), 0);  // nothing came
  write_whole_file(path, bytes("whole"));
  EXPECT_EQ(::read(reading.fd(), got.data(), got.size()), 5);
}

TEST_F(OutputPlaces, SayWhatCannotBeWritten) {
  EXPECT_THROW(open_stream(directory_.string()), OutputError);
  EXPECT_FALSE(open_stream(name("new")).has_value());
  ASSERT_EQ(::mkfifo(name("pipe").c_str(), 0600), 0);
  EXPECT_THROW(require_file_place(name("pipe"), "a table needs a file"), OutputError);
  EXPECT_THROW(require_file_place("-", "a table needs a file"), OutputError);
  EXPECT_THROW(require_plain(name("pipe")), OutputError);
  write_whole_file(name("file"), bytes("text"));
  EXPECT_NO_THROW(require_plain(name("file")));
  fs::create_symlink("file", name("link"));
  EXPECT_THROW(require_plain(name("link")), OutputError);
  EXPECT_THROW(require_other_file(name("link"), std::array{name("other"), name("file")}), OutputError);
  EXPECT_NO_THROW(require_other_file(name("new"), std::array{name("file")}));
}

TEST_F(OutputPlaces, UnfinishedFilesOfOthersAreNotTakenOver) {
  write_whole_file(name("victim"), bytes("keep"));
  fs::create_symlink("victim", name("file.part"));
  EXPECT_THROW(AtomicFile(name("file")), OutputError);
  fs::remove(name("file.part"));
  fs::create_hard_link(name("victim"), name("file.part"));
  EXPECT_THROW(AtomicFile(name("file")), OutputError);
  EXPECT_EQ(content(name("victim")), "keep");
  fs::remove(name("file.part"));
  write_whole_file(name("file.part"), bytes("left by a killed process"));
  write_whole_file(name("file"), bytes("text"));
  EXPECT_EQ(content(name("file")), "text");
}

TEST_F(OutputPlaces, OfTwoThatWriteTheSameFileTheLaterOneWins) {
  AtomicFile first(name("file"));
  AtomicFile second(name("file"));
  ASSERT_EQ(write_at(second.fd(), bytes("second"), 0), 0);
  EXPECT_NE(first.rename(), 0);
  EXPECT_EQ(second.rename(), 0);
  EXPECT_EQ(content(name("file")), "second");
}

}  // namespace
}  // namespace sigmasweep
