// Tuples from a list: points.
#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/sweep/content_key.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "support/spec_refusal.hpp"

using namespace sigmasweep;

namespace {

const std::string rest = "epsilon = 0.9\n";

std::string spec_of(const std::string& csv, const std::string& more) {
  return "[sweep]\npoints = '''\n" + csv + "'''\n" + more;
}

Sweep with_points(const std::string& csv, const std::string& more) {
  return Sweep::parse(spec_of(csv, more), "test.toml");
}

std::string refusal(const std::string& csv, const std::string& more = rest) {
  return refusal_of(spec_of(csv, more), "test.toml");
}

class PointsFile : public ::testing::Test {
 protected:
  PointsFile() { std::filesystem::create_directory(directory_); }
  ~PointsFile() override { std::filesystem::remove_all(directory_); }
  std::string path(const std::string& name) const { return (directory_ / name).string(); }

 private:
  const std::filesystem::path directory_ =
      std::filesystem::temp_directory_path() / ("sigmasweep-points-" + std::to_string(::getpid()));
};

}  // namespace

TEST(Points, AreTuplesThatMultiplyWithOtherAxes) {
  const Sweep sweep = with_points("# measured\nv0, tc ,N,sigma,method\n1,1e-5,3,+0.5,md\n\n2,2e-5,4.0,1e0,\"ed\"\r\n",
                                  "epsilon = [0.8, 0.9]\n");
  ASSERT_EQ(sweep.size(), 4U);
  for (const std::uint64_t row : {0U, 1U, 2U, 3U}) {
    const Parameters p = sweep.at(row);
    EXPECT_EQ(p.v0, row < 2 ? 1 : 2);
    EXPECT_EQ(p.tc, row < 2 ? 1e-5 : 2e-5);
    EXPECT_EQ(p.N, row < 2 ? 3 : 4);
    EXPECT_EQ(p.sigma, row < 2 ? 0.5 : 1.0);
    EXPECT_EQ(p.method, row < 2 ? Method::md : Method::ed);
    EXPECT_EQ(p.epsilon, row % 2 == 0 ? 0.8 : 0.9);
  }
}

TEST(Points, OfSeedsAreExact) {
  const Sweep sweep = with_points("v0,tc,N,sigma,seed\n1,1e-5,3,1,9007199254740993\n", rest + "width = 1e-4\n");
  EXPECT_EQ(sweep.at(0).seed, 9007199254740993);
}

TEST(Points, MistakesNameLineAndColumn) {
  const std::string header = "v0,tc,N,sigma\n", place = "test.toml:";
  EXPECT_EQ(refusal(header + "1,1e-5,3,1\n1,1e-5,3\n"), place + "5: sweep.points: 3 values under 4 names");
  EXPECT_EQ(refusal(header + "1,x,3,1\n"), place + "4: sweep.points: column 2, tc = \"x\": must be a number");
  EXPECT_EQ(refusal(header + "1,2*10^-5,3,1\n"),
            place + "4: sweep.points: column 2, tc = \"2*10^-5\": must be a number (write 2e-5)");
  EXPECT_EQ(refusal(header + "1,1e-5,3.5,1\n"), place + "4: sweep.points: column 3, N = 3.5: must be a whole number");
  EXPECT_EQ(refusal(header + "-1,1e-5,3,1\n").substr(0, 60),
            std::string("test.toml:4: sweep.points: column 1, v0 = -1 is not allowed: it").substr(0, 60));
  EXPECT_EQ(refusal("v0,tc,N,sigmq\n1,1,1,1\n").substr(0, 60),
            std::string("test.toml:3: sweep.points: column 4: 'sigmq' is no parameter (did").substr(0, 60));
  EXPECT_EQ(refusal("v0,tc,N,eps_eff\n1,1,1,1\n").substr(0, 60),
            std::string("test.toml:3: sweep.points: column 4: 'eps_eff' is a result, no").substr(0, 60));
  EXPECT_EQ(refusal("v0,tc,N,v0\n1,1,1,1\n"), place + "3: sweep.points: column 4: 'v0' is there twice");
  EXPECT_EQ(refusal("v0,tc,N,sigma\n").substr(0, 33), "test.toml:3: sweep.points: points");
  EXPECT_EQ(refusal(header + "1,1e-5,3,1\n", rest + "v0 = 3\n"),
            "test.toml:7: sweep.v0: is given by the points in line 2");
}

TEST_F(PointsFile, StandInTheTextOfTheSpec) {
  std::filesystem::create_directory(path("data"));
  std::ofstream(path("data/points.csv")) << "v0,tc,N,sigma\n1,1e-5,3,0.5\n2,2e-5,4,\"1\"\n";
  std::ofstream(path("s.toml")) << "[sweep]\npoints = \"data/points.csv\"  # ours\n" << rest;
  const Sweep sweep = Sweep::load(path("s.toml"));
  ASSERT_EQ(sweep.size(), 2U);
  const Sweep stored = Sweep::parse_stored(sweep.text(), "stored");
  for (const std::uint64_t row : {0U, 1U}) EXPECT_EQ(content_key(stored.at(row)), content_key(sweep.at(row)));
}

TEST_F(PointsFile, MistakesNameIt) {
  const auto said = [&](const std::string& csv) {
    std::ofstream(path("p.csv")) << csv;
    std::ofstream(path("s.toml")) << "[sweep]\npoints = \"p.csv\"\n" << rest << "x = 1\n";
    try {
      Sweep::load(path("s.toml"));
    } catch (const SpecError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(said("v0,tc\n1,abc\n").substr(0, 45), "p.csv:2: column 2, tc = \"abc\": must be a numb");
  EXPECT_NE(said("v0,tc\n1,abc\n").find("s.toml:4: unknown key sweep.x"), std::string::npos);
}

TEST_F(PointsFile, ThatIsNotThereIsNamed) {
  std::ofstream(path("s.toml")) << "[sweep]\npoints = \"none.csv\"\n" << rest;
  EXPECT_THROW(Sweep::load(path("s.toml")), InputNotFound);
  EXPECT_THROW(Sweep::parse("[sweep]\npoints = \"none.csv\"\n" + rest, "test.toml"), SpecError);
}
