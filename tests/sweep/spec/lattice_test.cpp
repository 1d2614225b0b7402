#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/assembly/validity.hpp"
#include "sigmasweep/model/names.hpp"
#include "sigmasweep/model/relevance.hpp"
#include "sigmasweep/solve/cost.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "support/columns.hpp"
#include "support/spec_refusal.hpp"

/// Specs with geometry = "lattice" and "vibrated-lattice".
using namespace sigmasweep;

namespace {

/// [sweep] on line 1, `more` from line 5 on.
std::string spec_with(const std::string& more, const std::string& geometry = "\"lattice\"") {
  return "[sweep]\ngeometry = " + geometry + "\ntc = 2e-5\nepsilon = 0.9\n" + more + "\n";
}
Sweep with(const std::string& more) { return Sweep::parse(spec_with(more), "lattice.toml"); }

std::string refusal(const std::string& text) { return refusal_of(text, "lattice.toml"); }
std::string wrong(const std::string& more) { return refusal(spec_with(more)); }

std::vector<std::string> columns(const Sweep& sweep) {
  std::vector<std::string> names;
  for (const Field& field : sweep.columns()) names.emplace_back(field.name);
  return names;
}

/// Lines 5 to 7.
const std::string flies = "v0 = 0.05\ns0 = 1e-6\nrows = 10\n";
const std::string vibrates = "alpha = 2\nrows = 4\n";
const std::string both = "[\"lattice\", \"column\"]";

}  // namespace

TEST(LatticeSweep, HasRowsTimesColumnsBeads) {
  const Parameters p = with(flies).at(0);
  EXPECT_EQ(p.geometry, Geometry::lattice);
  EXPECT_EQ(p.rows, 10);
  EXPECT_EQ(p.columns, 13);
  EXPECT_EQ(p.N, 130);
  EXPECT_EQ(p.side_walls, SideWalls::periodic);
  EXPECT_EQ(p.D_t, 0.0);
  EXPECT_DOUBLE_EQ(p.sigma, 1.0);
  EXPECT_EQ(why_invalid(p), "");
  const Sweep walls = with(flies + "columns = [5, 7]\nD_t = 1e3\nside_walls = [\"periodic\", \"fixed\"]");
  ASSERT_EQ(walls.size(), 4u);
  EXPECT_EQ(walls.at(3).N, 70);
  EXPECT_EQ(walls.at(3).D_t, 1e3);
  EXPECT_EQ(walls.at(0).side_walls, SideWalls::periodic);
  EXPECT_EQ(walls.at(3).side_walls, SideWalls::fixed);
}

TEST(LatticeSweep, TakesSpringsAndMaterialsToo) {
  const std::string rest = "geometry = \"lattice\"\nrows = 2\nv0 = 1\nsigma = 0.1\n";
  EXPECT_EQ(refusal("[sweep]\n" + rest + "K_over_m = 1e10\nD_n = 1e4"), "accepted");
  const Sweep steel = Sweep::parse("[sweep]\n" + rest + "material = [\"steel\", \"aluminium\"]\nlaw = \"hertz\"", "l");
  for (const std::uint64_t row : {0, 1}) {
    EXPECT_EQ(steel.at(row).N, 26);
    EXPECT_EQ(steel.at(row).d, 1.5e-3);
    EXPECT_EQ(why_invalid(steel.at(row)), "");
  }
  EXPECT_EQ(wrong(flies + "random_separation = true\nseed = [1, 2]\nwidth = 1e-4"), "accepted");
}

TEST(LatticeSweep, HasItsOwnColumns) {
  EXPECT_EQ(columns(with(flies)), golden::table_of(Geometry::lattice));
  EXPECT_EQ(std::ranges::count(columns(with(flies + "D_t = [1, 2]")), "D_t"), 1);
  EXPECT_EQ(std::ranges::count(columns(with(flies + "integrator = \"rk4\"")), "predicted_growth"), 1);
  EXPECT_EQ(columns(Sweep::parse(spec_with(vibrates, "\"vibrated-lattice\""), "l")),
            golden::table_of(Geometry::vibrated_lattice));
}

TEST(LatticeSweep, CountsItsBeadsItself) {
  EXPECT_EQ(wrong(flies + "N = 130"),
            "lattice.toml:8: sweep.N: no tuple uses it: it needs geometry = 'column' or 'vibrated-column'; of a "
            "lattice N = rows x columns, which are given instead");
  EXPECT_EQ(wrong("v0 = 1\ns0 = 0"),
            "lattice.toml:1: sweep: 'rows' is missing: v0, rows, one of s0 and sigma, and tc and epsilon (or instead "
            "of these K_over_m and D_n, or a material) are needed");
  EXPECT_EQ(refusal(spec_with("alpha = 2", "\"vibrated-lattice\"")),
            "lattice.toml:1: sweep: 'rows' is missing: rows, one of alpha and A0, and tc and epsilon (or instead of "
            "these K_over_m and D_n, or a material) are needed");
  expect_part(wrong("rows = 10\ns0 = 0"), "'v0' is missing");
  expect_part(wrong("rows = 10\nv0 = 1"), "one of 's0' and 'sigma' is missing");
  expect_part(refusal(spec_with("rows = 10", "\"vibrated-lattice\"")), "one of 'alpha' and 'A0' is missing");
}

TEST(LatticeSweep, BesideColumnsHasNForThem) {
  const Sweep sweep = Sweep::parse(spec_with("v0 = 0.05\ns0 = 0\nrows = [2, 3]\nN = [2, 3]\ncolumns = 5\n"
                                             "zip = [[\"rows\", \"N\"]]\nseed = 1\nwidth = 1e-4",
                                             both),
                                   "l");
  ASSERT_EQ(sweep.size(), 4u);  // geometry first
  EXPECT_EQ(sweep.at(0).N, 10);
  EXPECT_EQ(sweep.at(1).N, 15);
  EXPECT_EQ(sweep.at(2).N, 2);
  EXPECT_EQ(sweep.at(3).N, 3);
  EXPECT_EQ(sweep.at(3).rows, 3);  // of no meaning, but what a plot of both may go against
  for (const char* present : {"N", "rows", "columns", "geometry"})
    EXPECT_EQ(std::ranges::count(columns(sweep), present), 1) << present;
  expect_part(refusal(spec_with("v0 = 1\ns0 = 0\nrows = 2", both)), "'N' is missing: v0, N, rows, one of");
  expect_part(refusal(spec_with("v0 = 1\ns0 = 0\nN = 2", both)), "'rows' is missing: v0, N, rows, one of");
}

TEST(LatticeSweep, ColumnsHaveNoneOfItsParameters) {
  for (const char* key : {"rows = 10", "columns = 13", "D_t = 0", "side_walls = \"fixed\""}) {
    EXPECT_EQ(refusal(spec_with("v0 = 1\ns0 = 0\nN = 3\n" + std::string(key), "\"column\"")),
              "lattice.toml:8: sweep." + std::string(key).substr(0, std::string(key).find(' ')) +
                  ": no tuple uses it: it needs geometry = 'lattice' or 'vibrated-lattice'");
    expect_part(refusal(spec_with("alpha = 2\nN = 3\n" + std::string(key), "\"vibrated-column\"")), "no tuple uses it");
  }
  expect_part(wrong(flies + "alpha = 2"), "it needs geometry = 'vibrated-column' or 'vibrated-lattice'");
  expect_part(refusal(spec_with(vibrates + "tolerance = 1e-6", "\"vibrated-lattice\"")),
              "it needs geometry = 'column' or 'lattice'");
}

TEST(LatticeSweep, RefusesBadLattices) {
  expect_part(wrong(flies + "columns = 0"), "lattice.toml:8: sweep.columns = 0 is not allowed: it must be a whole");
  expect_part(wrong("rows = -1"), "lattice.toml:5: sweep.rows = -1 is not allowed");
  expect_part(wrong("rows = 2.5"), "lattice.toml:5: sweep.rows = 2.5: must be a whole number");
  expect_part(wrong("rows = 1e15"), "lattice.toml:5: sweep.rows = 1000000000000000 is not allowed");
  expect_part(wrong(flies + "D_t = -1"), "lattice.toml:8: sweep.D_t = -1 is not allowed: it must be finite and >= 0");
  expect_part(wrong(flies + "D_t = nan"), "lattice.toml:8: sweep.D_t = nan is not allowed");
  EXPECT_EQ(wrong(flies + "side_walls = \"open\""),
            "lattice.toml:8: sweep.side_walls = \"open\": must be 'periodic' or 'fixed'");
  const std::string long_and_wide = "v0 = 1\ns0 = 0\nrows = [1, 1000]\ncolumns = [1001, 1]";
  EXPECT_EQ(wrong(long_and_wide),
            "lattice.toml:8: sweep.columns: rows = 1000, columns = 1001 are not allowed: 1000000 beads are the most.");
  EXPECT_EQ(wrong(long_and_wide + "\nzip = [[\"rows\", \"columns\"]]"), "accepted");
  expect_part(wrong("v0 = 1\ns0 = 0\nrows = 100000"), "lattice.toml:7: sweep.rows: rows = 100000, columns = 13");
}

TEST(LatticeSweep, IsSoft) {
  const std::string why = "sweep.method: hard spheres, 'ed', are for columns only: a lattice needs method = 'md'";
  EXPECT_EQ(wrong(flies + "method = \"ed\""), "lattice.toml:8: " + why);
  EXPECT_EQ(refusal(spec_with("method = [\"md\", \"ed\"]\n" + vibrates, "\"vibrated-lattice\"")),
            "lattice.toml:5: " + why);
  EXPECT_EQ(refusal(spec_with(vibrates + "method = \"ed\"", "\"vibrated-lattice\"")), "lattice.toml:7: " + why);
  const std::string mixed = flies + "N = 10\nmethod = [\"md\", \"ed\"]\n";
  EXPECT_EQ(refusal(spec_with(mixed, both)), "lattice.toml:9: " + why);
  EXPECT_EQ(refusal(spec_with(mixed + "zip = [[\"geometry\", \"method\"]]", both)), "accepted");
  EXPECT_EQ(refusal(spec_with(mixed + "where = \"geometry == column || method == md\"", both)), "accepted");
  EXPECT_EQ(refusal(spec_with(mixed + "where = \"geometry == lattice || method == md\"", both)),
            "lattice.toml:9: " + why);
}

TEST(LatticeSweep, HasTrajectoriesAndStudies) {
  EXPECT_EQ(wrong(flies + "[precision]\n"), "accepted");
  EXPECT_EQ(wrong(flies + "integrator = \"rk4\"\n[plot]\nkind = \"stability\"\n"), "accepted");
  EXPECT_EQ(refusal(spec_with(vibrates + "[precision]\n", "\"vibrated-lattice\"")), "accepted");
  EXPECT_EQ(wrong(flies + "[trajectory]\n"), "accepted");
  EXPECT_EQ(refusal(spec_with(flies + "N = 3\n[trajectory]\nwhere = \"geometry == column\"", both)), "accepted");
  EXPECT_EQ(refusal(spec_with(vibrates + "[trajectory]\n", "\"vibrated-lattice\"")), "accepted");
}

TEST(LatticeSweep, IsPlottedLikeAColumn) {
  EXPECT_EQ(with(flies).plots().front().x, "sigma");
  EXPECT_EQ(with(flies).plots().front().y, "eps_eff");
  EXPECT_EQ(Sweep::parse(spec_with(vibrates, "\"vibrated-lattice\""), "l").plots().front().y, "h_cm_excess");
  EXPECT_EQ(wrong(flies + "where = \"side_walls == periodic && rows*columns == N\"\n"
                          "[plot]\nx = \"geometry == lattice ? rows : N\"\nseries = [\"side_walls\", \"D_t\"]"),
            "accepted");
}

TEST(LatticeSweep, AndItsFieldsAreUsedByItAlone) {
  Parameters lattice, column;
  lattice.geometry = Geometry::lattice;
  lattice = complete(lattice, GapParameter::s0);
  for (const char* name : {"rows", "columns", "D_t", "side_walls"}) {
    EXPECT_TRUE(applies_to(*find_field(name), lattice)) << name;
    EXPECT_FALSE(applies_to(*find_field(name), column)) << name;
  }
  EXPECT_FALSE(applies_to(*find_field("N"), lattice));
  EXPECT_TRUE(applies_to(*find_field("N"), column));
}

TEST(LatticeSweep, GapsThatTakeTheDigitsOfPositionsAreRefused) {
  const std::string wide = "v0 = 0.05\ns0 = 1e86\nrows = [2, 20]\n", why = "positions would lose their digits";
  EXPECT_NE(wrong(wide).find(why), std::string::npos);
  const auto only = [&](const std::string& geometry) {
    return refusal(spec_with(wide + "N = 3\nwhere = \"geometry == " + geometry + "\"", both));
  };
  EXPECT_NE(only("lattice").find(why), std::string::npos) << only("lattice");
  EXPECT_EQ(only("column").find(why), std::string::npos) << only("column");
}

TEST(LatticeCost, IsPositiveFiniteAndGrows) {
  for (const Geometry geometry : {Geometry::lattice, Geometry::vibrated_lattice})
    for (const Integrator integrator : values_of<Integrator>())
      for (const double sigma : {0.0, 1.0, 1e9, std::numeric_limits<double>::max(), std::nan("")}) {
        Parameters p;
        p.geometry = geometry;
        p.integrator = integrator;
        p.sigma = sigma;
        derive_beads(p);
        const double time = predicted_time(p);
        EXPECT_TRUE(std::isfinite(time) && time > 0.0) << time;
        p.rows *= 2;
        derive_beads(p);
        EXPECT_GT(predicted_time(p), 1.9 * time);
      }
}
