// Pictures of lattices.
#include "plot/films/lattice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sigmasweep/base/errors.hpp"
#include "support/store_samples.hpp"

namespace sigmasweep {
namespace {

/// Two beads of 1 mm that sink to 0.3 mm above the bottom and rise again, in 101 samples of 1 ms.
Panel bouncing() {
  Panel panel;
  panel.row.parameters.geometry = Geometry::lattice;
  panel.row.parameters.tc = 1e-2;
  Trajectory& t = panel.trajectory;
  t.mass = {1.0, 1.0};
  t.diameter = {1e-3, 1e-3};
  t.box_width = 2e-3;
  t.periodic = true;
  for (int s = 0; s <= 100; ++s) {
    t.time.push_back(1e-3 * s);
    const double height = 0.3e-3 + 2e-5 * std::abs(s - 40);
    t.z.insert(t.z.end(), {height, height + 1e-3});
    t.x.insert(t.x.end(), {1e-4 - 2e-3, 1e-3});
    t.velocity.insert(t.velocity.end(), {s < 40 ? -1.0 : 1.0, 0.0});
    t.x_velocity.insert(t.x_velocity.end(), {0.0, 0.0});
  }
  return panel;
}

std::vector<std::size_t> samples_of(const Panel& panel) {
  std::vector<std::size_t> samples;
  for (const FilmFrame& frame : film_frames(panel)) samples.push_back(frame.sample);
  return samples;
}

TEST(PlotLattice, FramesBeforeDuringAndAfter) {
  Panel panel = bouncing();
  // It is lower than its radius, 0.5 mm, less than 10 samples from the lowest point.
  EXPECT_EQ(samples_of(panel), (std::vector<std::size_t>{0, 31, 35, 40, 60, 100}));
  for (std::size_t k = 110; k < panel.trajectory.z.size(); ++k)
    panel.trajectory.z[k] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(samples_of(panel), (std::vector<std::size_t>{0, 31, 35, 40, 44, 54}));
  panel.trajectory.z[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(film_frames(panel).empty());
}

TEST(PlotLattice, FramesOfThePlatesLastWholePeriod) {
  Panel panel = bouncing();
  panel.row.parameters.geometry = Geometry::vibrated_lattice;
  panel.row.parameters.frequency = 1.0 / 0.036;  // two and some periods
  EXPECT_EQ(samples_of(panel), (std::vector<std::size_t>{36, 42, 48, 54, 60, 66}));
}

/// A bead that sticks out to the left of a periodic container, 2 mm wide, is drawn on both sides.
TEST(PlotLattice, DrawsEveryForm) {
  const samples::Directory directory;
  Panel walled = bouncing(), nothing = bouncing(), plate = bouncing();
  walled.trajectory.periodic = false;
  nothing.trajectory.z.assign(202, std::numeric_limits<double>::quiet_NaN());
  const std::vector<Panel> panels{bouncing(), walled, nothing};
  const std::vector<std::string> differ{"sigma"};
  for (const char* name : {"a.svg", "a.png", "a.pdf"}) {
    plot_lattices(panels, differ, "it's `a` $(title) {_^}", directory.file(name));
    EXPECT_GT(std::filesystem::file_size(directory.file(name)), 2000u);
  }
  const std::string svg = samples::bytes_of(directory.file("a.svg"));
  for (const char* words : {"it's `a` $(title) {_^}", "first contact", "centre of mass lowest", "(c)"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  plate.row.parameters.geometry = Geometry::vibrated_lattice;
  plate.row.parameters.A0 = 1e-3;
  plot_lattices(std::vector<Panel>{plate}, differ, "plate", directory.file("b.svg"));
  EXPECT_NE(samples::bytes_of(directory.file("b.svg")).find("(m/s)"), std::string::npos);
}

TEST(PlotLattice, RefusesWhatFindsNoRoom) {
  const samples::Directory directory;
  EXPECT_THROW(plot_lattices({}, {}, "", directory.file("a.svg")), UsageError);
  EXPECT_THROW(plot_lattices(std::vector<Panel>(max_panels + 1), {}, "", directory.file("a.svg")), UsageError);
  EXPECT_THROW(plot_lattices(std::vector<Panel>{bouncing()}, {}, "", directory.file("a.gif")), UsageError);
  EXPECT_TRUE(directory.names().empty());
}

}  // namespace
}  // namespace sigmasweep
