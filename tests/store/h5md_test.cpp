// Trajectories to a file and back. That the file is H5MD an independent reader says: tests/cli/trajectory_test.py.
#include "store/h5md.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>

#include "sigmasweep/base/errors.hpp"
#include "support/parameters.hpp"
#include "support/store_samples.hpp"

namespace sigmasweep {
namespace {

using samples::bytes_of;
using samples::Directory;
using samples::put_bytes;

constexpr double any = std::numeric_limits<double>::quiet_NaN();

Tuple tuple() {
  Parameters p{.v0 = 0.2, .tc = 0.7e-5, .s0 = 1e-6};
  p.N = 4;
  p.width = 1e-4;
  return {17, completed(p)};
}

Trajectory film() { return record(tuple().parameters, sample_times(1e-4, 51)); }

TEST(H5md, ComesBackToTheBit) {
  const Directory directory;
  const std::string path = directory.file("a.h5");
  const Trajectory written = film();
  write_h5md(path, tuple(), written);
  EXPECT_EQ(directory.names(), std::vector<std::string>{"a.h5"});
  const Trajectory read = read_h5md(path);
  EXPECT_EQ(read.time, written.time);
  EXPECT_EQ(read.z, written.z);
  EXPECT_EQ(read.velocity, written.velocity);
  EXPECT_EQ(read.mass, written.mass);
  EXPECT_EQ(read.diameter, written.diameter);
  EXPECT_NE(written.mass[0], written.mass[1]);
  EXPECT_FALSE(read.is_plane());
}

TEST(H5md, LatticesComeBackToTheBit) {
  const Directory directory;
  for (const SideWalls side_walls : {SideWalls::periodic, SideWalls::fixed}) {
    Parameters p{.v0 = 0.2, .tc = 1e-5, .s0 = 1e-6, .width = 1e-4};
    p.geometry = Geometry::lattice;
    p.rows = 2;
    p.columns = 3;
    p.side_walls = side_walls;
    p.random_separation = Flag::yes;
    derive_beads(p);
    p = completed(p);
    const Trajectory written = record(p, sample_times(1e-4, 21));
    const std::string path = directory.file("lattice.h5");
    write_h5md(path, {0, p}, written);
    EXPECT_TRUE(is_h5md_of(path, p, 21, 1e-4));
    const Trajectory read = read_h5md(path);
    EXPECT_EQ(read.time, written.time);
    EXPECT_EQ(read.x, written.x);
    EXPECT_EQ(read.z, written.z);
    EXPECT_EQ(read.x_velocity, written.x_velocity);
    EXPECT_EQ(read.velocity, written.velocity);
    EXPECT_EQ(read.mass, written.mass);
    EXPECT_EQ(read.diameter, written.diameter);
    EXPECT_EQ(read.box_width, written.box_width);
    EXPECT_EQ(read.periodic, written.periodic);
    EXPECT_NE(written.x_velocity[125], 0.0);
    EXPECT_EQ(read.periodic, side_walls == SideWalls::periodic);
  }
}

TEST(H5md, SameBytesAlways) {
  const Directory directory;
  write_h5md(directory.file("a.h5"), tuple(), film());
  write_h5md(directory.file("b.h5"), tuple(), film());
  EXPECT_EQ(bytes_of(directory.file("a.h5")), bytes_of(directory.file("b.h5")));
}

TEST(H5md, KnowsWhatItIsOf) {
  const Directory directory;
  const std::string path = directory.file("a.h5");
  const Parameters p = tuple().parameters;
  EXPECT_FALSE(is_h5md_of(path, p, 51, 1e-4));
  write_h5md(path, tuple(), film());
  EXPECT_TRUE(is_h5md_of(path, p, 51, 1e-4));
  EXPECT_TRUE(is_h5md_of(path, p, 51, any));
  EXPECT_FALSE(is_h5md_of(path, p, 52, any));
  EXPECT_FALSE(is_h5md_of(path, p, 51, std::nextafter(1e-4, 1.0)));
  Parameters other = p;
  other.epsilon = std::nextafter(p.epsilon, 1.0);
  EXPECT_FALSE(is_h5md_of(path, other, 51, any));
  put_bytes(path, "something else");
  EXPECT_FALSE(is_h5md_of(path, p, 51, any));
}

TEST(H5md, BrokenFilesAreRefused) {
  const Directory directory;
  const std::string path = directory.file("a.h5");
  EXPECT_THROW(read_h5md(path), InputNotFound);
  write_h5md(path, tuple(), film());
  const std::string whole = bytes_of(path);
  for (const double share : {0.0, 0.1, 0.5, 0.99}) {
    put_bytes(path, whole.substr(0, static_cast<std::size_t>(share * double(whole.size()))));
    EXPECT_NE(samples::message_of<IoError>([&] { read_h5md(path); }).find(path), std::string::npos);
    EXPECT_FALSE(is_h5md_of(path, tuple().parameters, 51, 1e-4));
  }
}

/// A limit on file sizes is a disk that is full.
TEST(H5md, FullDiskLeavesNothing) {
  const Directory directory;
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small{4096, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message =
      samples::message_of<IoError>([&] { write_h5md(directory.file("a.h5"), tuple(), film()); });
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(message.find("a.h5"), std::string::npos);
  EXPECT_TRUE(directory.names().empty());
}

TEST(H5md, WhereNothingCanBeWritten) {
  const Directory directory;
  const std::string path = directory.file("missing/a.h5");
  EXPECT_NE(samples::message_of<OutputError>([&] { write_h5md(path, tuple(), film()); }).find(path), std::string::npos);
  std::filesystem::create_directory(directory.file("taken"));
  EXPECT_THROW(write_h5md(directory.file("taken"), tuple(), film()), OutputError);
  EXPECT_EQ(directory.names(), std::vector<std::string>{"taken"});
}

}  // namespace
}  // namespace sigmasweep
