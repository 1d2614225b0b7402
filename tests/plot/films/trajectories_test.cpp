#include "plot/films/trajectories.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "plot/films/thin.hpp"
#include "sigmasweep/base/errors.hpp"
#include "support/store_samples.hpp"

namespace sigmasweep {
namespace {

std::vector<plot::Point> line(std::size_t points) {
  std::vector<plot::Point> p;
  for (std::size_t i = 0; i < points; ++i) p.push_back({double(i), std::abs(double(i) - 30.0)});
  return p;
}

TEST(Thinned, KeepsEndsAndCornersOnly) {
  const auto thin = plot::thinned(line(101), 100.0, 70.0, 1e-9);
  ASSERT_EQ(thin.size(), 3u);
  EXPECT_EQ(thin[0].x, 0.0);
  EXPECT_EQ(thin[1].x, 30.0);
  EXPECT_EQ(thin[2].x, 100.0);
}

TEST(Thinned, StaysWithinTheTolerance) {
  std::vector<plot::Point> wave;
  for (int i = 0; i <= 2000; ++i) wave.push_back({i / 2000.0, 1e-6 * std::sin(i / 100.0)});
  const double tolerance = 1e-3;
  const auto thin = plot::thinned(wave, 1.0, 1e-6, tolerance);
  EXPECT_LT(thin.size(), 300u);
  std::size_t next = 1;
  for (const auto& p : wave) {
    while (thin[next].x < p.x) ++next;
    const auto &a = thin[next - 1], &b = thin[next];
    const double y = std::lerp(a.y, b.y, (p.x - a.x) / (b.x - a.x));
    const double slope = (b.y - a.y) / 1e-6 / (b.x - a.x);
    EXPECT_LE(std::abs(p.y - y) / 1e-6, tolerance * std::hypot(1.0, slope) * (1 + 1e-9));
  }
}

TEST(Thinned, LeavesOutWhatIsNoNumber) {
  auto points = line(50);
  points[10].y = points[49].y = std::numeric_limits<double>::quiet_NaN();
  const auto thin = plot::thinned(points, 50.0, 50.0, 1e-9);
  ASSERT_EQ(thin.size(), 3u);
  EXPECT_EQ(thin[2].x, 48.0);
  EXPECT_TRUE(plot::thinned({}, 1.0, 1.0, 1e-3).empty());
}

TEST(PlotTrajectories, RefusesWhatFindsNoRoom) {
  const samples::Directory directory;
  const std::vector<Panel> many(max_panels + 1);
  EXPECT_THROW(plot_trajectories(many, 5, {}, "", directory.file("a.svg")), UsageError);
  EXPECT_THROW(plot_trajectories({}, 5, {}, "", directory.file("a.svg")), UsageError);
  EXPECT_TRUE(directory.names().empty());
}

/// Also what a solver gave up, and a title that is no markup.
TEST(PlotTrajectories, DrawsEveryForm) {
  const samples::Directory directory;
  Panel panel;
  panel.row.parameters.N = 2;
  panel.trajectory = {.time = {0.0, 1e-3, 2e-3},
                      .z = {0.0, 1e-9, -1e-9, 0.0, 1e-9, 2e-9},
                      .velocity = std::vector<double>(6),
                      .mass = {1.0, 1.0},
                      .diameter = {1e-3, 1e-3}};
  Panel nothing = panel;
  nothing.trajectory.z.assign(6, std::numeric_limits<double>::quiet_NaN());
  const std::vector<Panel> panels{panel, nothing, panel};
  const std::vector<std::string> differ{"method", "s0"};
  for (const char* name : {"a.svg", "a.png", "a.pdf"}) {
    plot_trajectories(panels, 2, differ, "it's `a` $(title) {_^}", directory.file(name));
    EXPECT_GT(std::filesystem::file_size(directory.file(name)), 1000u);
  }
  const std::string svg = samples::bytes_of(directory.file("a.svg"));
  for (const char* words : {"it's `a` $(title) {_^}", "(ms)", "(nm)", "MD"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
}

/// A bead at rest on a plate of 2 mm, for two and a half of its periods.
TEST(PlotTrajectories, DrawsThePlateAgainstTimeOrPhase) {
  const samples::Directory directory;
  Panel panel;
  panel.row.parameters.geometry = Geometry::vibrated_column;
  panel.row.parameters.N = 1;
  panel.row.parameters.A0 = 2e-3;
  panel.row.parameters.frequency = 20.0;
  panel.trajectory = {.time = {}, .z = {}, .velocity = {}, .mass = {1.0}, .diameter = {1e-3}};
  for (int s = 0; s <= 1000; ++s) {
    panel.trajectory.time.push_back(0.125 * s / 1000.0);
    panel.trajectory.z.push_back(2e-3 * std::sin(40.0 * 3.141592653589793 * panel.trajectory.time.back()));
  }
  panel.trajectory.velocity.resize(1001);
  const std::vector<Panel> panels{panel};
  const std::vector<std::string> differ{"tc"};
  plot_trajectories(panels, 1, differ, "time", directory.file("time.svg"));
  plot_trajectories(panels, 1, differ, "phase", directory.file("phase.svg"), true);
  const std::string time = samples::bytes_of(directory.file("time.svg"));
  const std::string phase = samples::bytes_of(directory.file("phase.svg"));
  for (const char* words : {"periods", "mm", "144, 144, 144"}) EXPECT_NE(time.find(words), std::string::npos) << words;
  EXPECT_EQ(time.find("phase "), std::string::npos);
  for (const char* words : {"phase ", "mm"}) EXPECT_NE(phase.find(words), std::string::npos) << words;
  EXPECT_EQ(phase.find("periods"), std::string::npos);
}

}  // namespace
}  // namespace sigmasweep
