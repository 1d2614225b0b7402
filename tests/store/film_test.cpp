// The forces in films are those that move the beads.
#include "store/films/film.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "sigmasweep/trajectory/trajectory.hpp"
#include "store/films/formats.hpp"
#include "support/parameters.hpp"

namespace sigmasweep {
namespace {

Film film_of(const Parameters& p, double duration, std::size_t samples) {
  return Film({7, p}, record(p, sample_times(duration, samples)));
}

/// Compares m dv of each bead with the integral of its forces, by trapezoids, over the whole film. Forces jump where
/// contacts close, by C v: an error of a step's length times that.
void expect_impulses(const Film& film, double tolerance) {
  const std::size_t last = film.samples() - 1;
  std::vector<Vec3> impulse(film.beads());
  for (std::size_t s = 0; s <= last; ++s) {
    const double dt = (film.time(std::min(s + 1, last)) - film.time(s == 0 ? 0 : s - 1)) / 2;
    const auto forces = film.forces(film.contacts(s));
    for (std::size_t i = 0; i < film.beads(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) impulse[i][axis] += forces[i][axis] * dt;
  }
  for (std::size_t i = 0; i < film.beads(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(impulse[i][axis], film.mass(i) * (film.velocity(last, i)[axis] - film.velocity(0, i)[axis]),
                  tolerance)
          << "bead " << i << " axis " << axis;
}

Parameters column(Law law) {
  Parameters p{.v0 = 0.2, .tc = 1e-5, .s0 = 1e-6};
  p.N = 4;
  p.law = law;
  p.width = 2e-4;
  return completed(p);
}

Parameters lattice(Law law, SideWalls side_walls) {
  Parameters p{.v0 = 0.2, .tc = 1e-5, .s0 = 1e-6, .width = 2e-4};
  p.geometry = Geometry::lattice;
  p.law = law;
  p.rows = 3;
  p.columns = 3;
  p.D_t = 2e4;
  p.side_walls = side_walls;
  p.random_separation = Flag::yes;
  derive_beads(p);
  return completed(p);
}

TEST(Film, ForcesOfColumnsMoveTheBeads) {
  for (const Law law : {Law::hooke, Law::hertz, Law::hertz_kuwabara_kono}) {
    SCOPED_TRACE(static_cast<int>(law));
    expect_impulses(film_of(column(law), 1e-4, 100'001), 1e-4 * 0.2);
  }
}

TEST(Film, ForcesOfLatticesMoveTheBeads) {
  for (const Law law : {Law::hooke, Law::hertz})
    for (const SideWalls side_walls : {SideWalls::periodic, SideWalls::fixed}) {
      SCOPED_TRACE(static_cast<int>(law));
      // From 6e-4 m within the fall the beads cross gaps of up to 1e-4 m.
      expect_impulses(film_of(lattice(law, side_walls), 1e-3, 100'001), 2e-3 * 0.2);
    }
}

TEST(Film, HardSpheresHaveNoForces) {
  Parameters p = column(Law::hooke);
  p.method = Method::ed;
  const Film film = film_of(completed(p), 1e-4, 11);
  EXPECT_FALSE(film.has_forces());
  for (std::size_t s = 0; s < film.samples(); ++s) EXPECT_TRUE(film.contacts(s).empty());
}

TEST(Film, EndsWhereTheSolverGaveUp) {
  const Parameters p = column(Law::hooke);
  Trajectory motion = record(p, sample_times(1e-4, 11));
  std::fill(motion.z.begin() + 5 * 4, motion.z.end(), std::nan(""));
  EXPECT_EQ(Film({0, p}, motion).samples(), 5U);
}

TEST(Film, AllFormatsNameTheirFilesByTheRow) {
  const Film film = film_of(column(Law::hooke), 1e-4, 3);
  for (const FilmFormat& format : film_formats()) {
    std::size_t files = 0;
    format.write(film, [&](const std::string& name, const std::string& text) {
      EXPECT_TRUE(name.starts_with("row-000007")) << name;
      EXPECT_FALSE(text.empty());
      ++files;
    });
    EXPECT_GE(files, 1U) << format.name;
  }
}

}  // namespace
}  // namespace sigmasweep
