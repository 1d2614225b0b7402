// Velocities by the phase of the plate, of motions that are made up.
#include "plot/films/velocity_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "assembly/ground.hpp"
#include "plot/films/plot_velocity_field.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/geometry.hpp"
#include "support/store_samples.hpp"

namespace sigmasweep {
namespace {

using Velocity = std::function<Vec2<double>(double x, double z, double phase)>;

/// 8 x 6 beads of 1 mm, one in each cell, at rest relative to a plate of 2 mm and 10 Hz, for nine periods of 40
/// samples. Their velocities are given, x and z from the middle of the beads, beside a common one.
Panel stirred(const Velocity& velocity, bool periodic = false) {
  Panel panel;
  Parameters& p = panel.row.parameters;
  p.geometry = Geometry::vibrated_lattice;
  p.frequency = 10.0;
  p.A0 = 2e-3;
  p.rows = 6;
  Trajectory& t = panel.trajectory;
  t.mass.assign(48, 1.0);
  t.diameter.assign(48, 1e-3);
  t.box_width = 8e-3;
  t.periodic = periodic;
  for (int s = 0; s <= 360; ++s) {
    t.time.push_back(s / 400.0);
    const double phase = (s % 40) / 40.0;
    for (int i = 0; i < 48; ++i) {
      const double x = (i % 8 + 0.5) * 1e-3, z = (i / 8 + 0.5) * 1e-3;
      const Vec2<double> v = velocity(x - 4e-3, z - 3e-3, phase);
      t.x.push_back(x + (periodic ? 8e-3 * (s % 3 - 1) : 0.0));
      t.z.push_back(z + plate_height(p, t.time.back()));
      t.x_velocity.push_back(v.x);
      t.velocity.push_back(v.z + plate_speed(p, t.time.back()));
    }
  }
  return panel;
}

constexpr double roundings = 1e-12;

VelocityField field_of(const Panel& panel, std::size_t phase) {
  const Panel* film = &panel;
  return velocity_field({&film, 1}, phase, 4);
}

/// Counterclockwise with 3/s in the second quarter of the period, the other way round in the others.
TEST(VelocityField, RigidRotationByPhase) {
  const Panel panel = stirred([](double x, double z, double phase) {
    const double rate = phase >= 0.25 && phase < 0.5 ? 3.0 : -1.0;
    return Vec2<double>{-rate * z, rate * x};
  });
  for (std::size_t phase = 0; phase < 4; ++phase) {
    const double rate = phase == 1 ? 3.0 : -1.0;
    const VelocityField field = field_of(panel, phase);
    ASSERT_EQ(field.columns, 8u);
    ASSERT_EQ(field.rows, 6u);
    for (std::size_t row = 0; row < 6; ++row)
      for (std::size_t column = 0; column < 8; ++column) {
        ASSERT_TRUE(field.has(column, row));
        EXPECT_NEAR(field.at(column, row).x, -rate * (double(row) - 2.5) * 1e-3, roundings);
        EXPECT_NEAR(field.at(column, row).z, rate * (double(column) - 3.5) * 1e-3, roundings);
      }
    const Rolls rolls = rolls_of(field);
    EXPECT_NEAR(rolls.left, 2 * rate, 1e3 * roundings);  // over cells of 1e-3 m
    EXPECT_NEAR(rolls.right, 2 * rate, 1e3 * roundings);
  }
}

/// v_z = -2 |x| /s + ...: down at the sides, up in the middle; curl 2 on the left and -2 on the right.
TEST(VelocityField, PairOfRolls) {
  for (const bool periodic : {false, true}) {
    const auto pair = [](double x, double, double) { return Vec2<double>{0.0, -2.0 * std::abs(x)}; };
    const Panel panel = stirred(pair, periodic);
    const Rolls rolls = rolls_of(field_of(panel, 2));
    // In each half 3 corners between cells, and those in the middle and at the joint, where the curl is 0.
    const double share = periodic ? 3.0 / 5.0 : 3.0 / 4.0;
    EXPECT_NEAR(rolls.left, 2.0 * share, 1e3 * roundings);
    EXPECT_NEAR(rolls.right, -2.0 * share, 1e3 * roundings);
  }
}

/// The beginning of the film, and cells where hardly anybody comes, do not count.
TEST(VelocityField, TransientAndRareGuestsAreLeftOut) {
  Panel panel = stirred([](double x, double z, double) { return Vec2<double>{-z, x}; });
  Trajectory& t = panel.trajectory;
  for (std::size_t k = 0; k < 120 * 48; ++k) t.x_velocity[k] = 1e6;  // three of nine periods
  t.z[200 * 48] += 9e-3;                                             // sample 200 is the first of a period
  const VelocityField field = field_of(panel, 0);
  EXPECT_EQ(field.rows, 10u);
  EXPECT_FALSE(field.has(0, 9));
  for (std::size_t column = 0; column < 8; ++column) {
    EXPECT_TRUE(field.has(column, 5));
    EXPECT_FALSE(field.has(column, 6));
  }
  EXPECT_NEAR(rolls_of(field).right, 2.0, 1e-3);  // one bead of one sample is missing in the mean velocity
  for (double& z : t.z) z = std::nan("");
  const Rolls nothing = rolls_of(field_of(panel, 0));
  EXPECT_TRUE(std::isnan(nothing.left) && std::isnan(nothing.right));
}

/// Three containers that rotate at 1/s, 2/s and 6/s.
TEST(VelocityField, BoxesThatHoldTooManyCellsAreRefused) {
  Panel film = stirred([](double, double, double) { return Vec2<double>{}; });
  const std::vector<const Panel*> one{&film};
  for (const double columns : {0x1p61, 0x1p61 + 512.0, 1e300}) {  // times the rows, 0 and 4096 modulo 2^64
    film.trajectory.box_width = columns * 1e-3;
    EXPECT_THROW(velocity_field(one, 0, 4), UsageError) << columns;
  }
}

TEST(VelocityField, FilmsAreAveraged) {
  std::vector<Panel> panels;
  for (const double rate : {1.0, 2.0, 6.0})
    panels.push_back(stirred([rate](double x, double z, double) { return Vec2<double>{-rate * z, rate * x}; }));
  const std::vector<const Panel*> films{&panels[0], &panels[1], &panels[2]};
  const VelocityField field = velocity_field(films, 0, 4);
  EXPECT_NEAR(field.at(7, 0).z, 3.0 * 3.5e-3, roundings);
  const MeanRolls rolls = mean_rolls(films, 0, 4);
  EXPECT_NEAR(rolls.mean.left, 6.0, 1e3 * roundings);
  // Curls of 2, 4 and 12: variance 28, standard error sqrt(28/3).
  EXPECT_NEAR(rolls.error.right, std::sqrt(28.0 / 3.0), 1e3 * roundings);
  EXPECT_TRUE(std::isnan(mean_rolls(Films(films).first(1), 0, 4).error.left));
  for (double& z : panels[2].trajectory.z) z = std::nan("");  // one that has nothing to say is none
  EXPECT_NEAR(mean_rolls(films, 0, 4).mean.left, 3.0, 1e3 * roundings);
}

TEST(PlotVelocityFields, DrawsEveryForm) {
  const samples::Directory directory;
  const auto roll = [](double x, double z, double) { return Vec2<double>{-3.0 * z, 3.0 * x}; };
  Panel nothing = stirred(roll);
  nothing.trajectory.z.assign(nothing.trajectory.z.size(), std::nan(""));
  const std::vector<Panel> panels{stirred(roll), stirred(roll, true), nothing};
  const std::vector<std::string> differ{"alpha"};
  for (const char* name : {"a.svg", "a.png", "a.pdf"}) {
    plot_velocity_fields(panels, differ, {}, "rolls", directory.file(name));
    EXPECT_GT(std::filesystem::file_size(directory.file(name)), 2000u);
  }
  const std::string svg = samples::bytes_of(directory.file("a.svg"));
  for (const char* words : {"left 6, right 6 /s", "longest arrow", "from 0.25 to 0.5"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  std::vector<Panel> seeds{stirred(roll), stirred(roll)};
  seeds[1].row.parameters.seed = 2;
  const std::vector<std::string> axes{"seed"};
  plot_velocity_fields(seeds, axes, axes, "rolls", directory.file("mean.svg"));
  EXPECT_NE(samples::bytes_of(directory.file("mean.svg")).find("mean of 2"), std::string::npos);
  seeds[1].trajectory.box_width *= 2.0;
  EXPECT_THROW(plot_velocity_fields(seeds, axes, axes, "", directory.file("b.svg")), UsageError);
  Panel flight = stirred(roll);
  flight.row.parameters.geometry = Geometry::lattice;
  EXPECT_THROW(plot_velocity_fields(std::vector<Panel>{flight}, differ, {}, "", directory.file("b.svg")), UsageError);
}

}  // namespace
}  // namespace sigmasweep
