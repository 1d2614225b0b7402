#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sigmasweep/assembly/validity.hpp"
#include "sigmasweep/model/relevance.hpp"
#include "sigmasweep/solve/cost.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "support/columns.hpp"
#include "support/spec_refusal.hpp"

/// Specs with geometry = "vibrated-column".
using namespace sigmasweep;

namespace {

/// [sweep] on line 1, `more` from line 5 on.
std::string spec_with(const std::string& more, const std::string& geometry = "\"vibrated-column\"") {
  return "[sweep]\ngeometry = " + geometry + "\nN = 10\nepsilon = 0.92\n" + more + "\n";
}
Sweep with(const std::string& more) { return Sweep::parse(spec_with(more), "vib.toml"); }

std::string refusal(const std::string& text) { return refusal_of(text, "vib.toml"); }
std::string wrong(const std::string& more) { return refusal(spec_with(more)); }

std::vector<std::string> columns(const Sweep& sweep) {
  std::vector<std::string> names;
  for (const Field& field : sweep.columns()) names.emplace_back(field.name);
  return names;
}

const std::string soft = "tc = 1e-4\n";

}  // namespace

TEST(VibratedSweep, NeedsNeitherSpeedNorGap) {
  const Sweep sweep = with(soft + "alpha = [2, 4]\nperiods = 50");
  ASSERT_EQ(sweep.size(), 2u);
  const Parameters p = sweep.at(1);
  EXPECT_EQ(p.geometry, Geometry::vibrated_column);
  EXPECT_EQ(p.alpha, 4.0);
  EXPECT_NEAR(p.A0, 2.484902028828334e-3, 1e-15);  // 4 * 9.81/(40 pi)^2
  EXPECT_EQ(p.periods, 50);
  EXPECT_EQ(p.s0, 0.0);
  EXPECT_EQ(why_invalid(p), "");
  EXPECT_EQ(with(soft + "A0 = 1.24e-3\ns0 = 1e-6").at(0).s0, 1e-6);
  EXPECT_EQ(wrong("method = \"ed\"\nalpha = 2"), "accepted");  // no contact time
}

TEST(VibratedSweep, HasItsOwnColumns) {
  EXPECT_EQ(columns(with(soft + "alpha = [2, 4]")), golden::table_of(Geometry::vibrated_column));
  const auto hard = columns(with("method = \"ed\"\nalpha = 2"));
  EXPECT_EQ(std::ranges::count(hard, "x_max"), 0);
  EXPECT_EQ(std::ranges::count(hard, "tc"), 0);
  const auto flying = columns(Sweep::parse(spec_with("v0 = 1\ns0 = 0\ntc = 1e-5", "\"column\""), "vib.toml"));
  for (const char* absent : {"h_cm", "gravity", "alpha", "periods"})
    EXPECT_EQ(std::ranges::count(flying, absent), 0) << absent;
}

TEST(VibratedSweep, MixedWithFlyingColumnsHasBoth) {
  const std::string both = "[\"column\", \"vibrated-column\"]";
  const Sweep sweep = Sweep::parse(spec_with("v0 = 0.5\nsigma = 2\nalpha = 2\n" + soft, both), "vib.toml");
  const auto names = columns(sweep);
  for (const char* present : {"v0", "sigma", "geometry", "alpha", "eps_eff", "h_cm"})
    EXPECT_EQ(std::ranges::count(names, present), 1) << present;
  EXPECT_EQ(sweep.at(0).s0, 1e-4);  // sigma v0 tc
  EXPECT_EQ(sweep.at(0).A0, 0.0);
  EXPECT_EQ(sweep.at(1).s0, 0.0);
  EXPECT_GT(sweep.at(1).A0, 0.0);
  expect_part(refusal(spec_with("sigma = 2\nalpha = 2\n" + soft, both)), "'v0' is missing");
  expect_part(refusal(spec_with("v0 = 2\nalpha = 2\n" + soft, both)), "one of 's0' and 'sigma' is missing");
}

TEST(VibratedSweep, RefusesWhatIsMissingOrTwice) {
  EXPECT_EQ(wrong(soft), "vib.toml:1: sweep: one of 'alpha' and 'A0' is missing");
  EXPECT_EQ(wrong(soft + "alpha = 2\nA0 = 1e-3"),
            "vib.toml:7: sweep.A0: give alpha or A0, not both: alpha = A0 (2 pi frequency)^2/gravity");
  EXPECT_EQ(wrong("alpha = 2"),
            "vib.toml:1: sweep: 'tc' is missing: N, one of alpha and A0, and tc and epsilon (or "
            "instead of these K_over_m and D_n, or a material) are needed");
}

TEST(VibratedSweep, RefusesWhatItDoesNotUse) {
  const std::string plate = soft + "alpha = 2\n";
  EXPECT_EQ(wrong(plate + "sigma = 1"),
            "vib.toml:7: sweep.sigma: no tuple uses it: it needs geometry = 'column' or "
            "'lattice'");
  EXPECT_EQ(wrong(plate + "v0 = 1"),
            "vib.toml:7: sweep.v0: no tuple uses it: it needs geometry = 'column' or 'lattice', or a law that is not "
            "linear");
  expect_part(wrong(plate + "tolerance = 1e-6"), "sweep.tolerance: no tuple uses it: it needs geometry = 'column'");
  expect_part(wrong("method = \"ed\"\nalpha = 2\ntc = 1e-5"), "sweep.tc: no tuple uses it");
  EXPECT_EQ(wrong("method = [\"ed\", \"md\"]\nalpha = 2\ntc = 1e-5"), "accepted");
  EXPECT_EQ(wrong(plate + "law = \"hertz\"\nv0 = 1"), "accepted");
  expect_part(wrong(plate + "law = \"hertz\""), "'v0' is missing");
  const auto flying = [](const std::string& more) {
    return refusal(spec_with("v0 = 1\ns0 = 0\ntc = 1e-5\n" + more, "\"column\""));
  };
  for (const char* key :
       {"gravity = 9.81", "frequency = 20", "alpha = 2", "A0 = 1e-3", "periods = 30", "transient = 3"})
    expect_part(flying(key), "no tuple uses it: it needs geometry = 'vibrated-column'");
}

TEST(VibratedSweep, RefusesBadPlates) {
  const auto bad = [](const std::string& more) { return wrong(soft + more); };
  expect_part(bad("alpha = 0"), "vib.toml:6: sweep.alpha = 0 is not allowed");
  expect_part(bad("alpha = 2e6"), "vib.toml:6: sweep.alpha = 2000000 is not allowed");
  expect_part(bad("A0 = -1e-3"), "vib.toml:6: sweep.A0 = -0.001 is not allowed");
  expect_part(bad("alpha = 2\ngravity = 0"), "vib.toml:7: sweep.gravity = 0 is not allowed");
  expect_part(bad("alpha = 2\nfrequency = inf"), "vib.toml:7: sweep.frequency = inf is not allowed");
  expect_part(bad("alpha = 2\nperiods = 0"), "vib.toml:7: sweep.periods = 0 is not allowed");
  expect_part(bad("alpha = 2\ntransient = -1"), "vib.toml:7: sweep.transient = -1 is not allowed");
  expect_part(bad("A0 = 1\nfrequency = [1, 1e4]"), "vib.toml:6: sweep.A0: with gravity = 9.81, frequency = 10000");
  EXPECT_EQ(bad("alpha = 2\nperiods = 20"),
            "vib.toml:7: sweep.periods: a transient of 20 periods must be shorter than all 20 periods");
  expect_part(bad("alpha = 2\nperiods = [10, 30]\ntransient = [5, 20]"),
              "vib.toml:8: sweep.transient: a transient of 20 periods");
  EXPECT_EQ(bad("alpha = 2\nperiods = [10, 30]\ntransient = [5, 20]\nzip = [[\"periods\", \"transient\"]]"),
            "accepted");
}

TEST(VibratedSweep, PrecisionComparesSoftSpheres) {
  EXPECT_EQ(wrong(soft + "alpha = 2\n[precision]\n"), "accepted");
  expect_part(wrong("method = \"ed\"\nalpha = 2\n[precision]\n"), "only soft spheres");
}

TEST(VibratedSweep, PlotsTheRiseAgainstAlphaUnlessToldOtherwise) {
  const std::string plate = soft + "alpha = 2\n";
  for (const char* plot : {"", "[plot]\n"}) {
    const PlotSpec usual = with(plate + plot).plots().front();
    EXPECT_EQ(usual.x, "alpha");
    EXPECT_EQ(usual.y, "h_cm_excess");
    EXPECT_FALSE(usual.x_log);
  }
  const PlotSpec own = with(plate +
                            "[plot]\nx = \"tc\"\ny = \"1e3*separation\"\nx_scale = \"log\"\n"
                            "y_error = \"1e3*h_cm_error\"")
                           .plots()
                           .front();
  EXPECT_EQ(own.x, "tc");
  EXPECT_EQ(own.y, "1e3*separation");
  EXPECT_EQ(own.y_error, "1e3*h_cm_error");
  EXPECT_TRUE(own.x_log);
  expect_part(wrong(plate + "[plot]\ny_error = \"h_cm_eror\""), "plot.y_error = \"h_cm_eror\": is no field");
  expect_part(wrong(plate + "[plot]\ny_error = \"h_cm_error\"\nmean_over = \"seed\""), "conflict");
}

TEST(VibratedSweep, FilmsGoAgainstTimeOrPhase) {
  const std::string film = soft + "alpha = 2\n[trajectory]\n[plot]\nkind = \"trajectories\"\n";
  EXPECT_FALSE(with(film).plots().front().by_phase);
  EXPECT_FALSE(with(film + "x = \"time\"").plots().front().by_phase);
  EXPECT_TRUE(with(film + "x = \"phase\"").plots().front().by_phase);
  expect_part(wrong(film + "x = \"alpha\""), "must be 'time' or 'phase'");
  expect_part(
      refusal(spec_with("v0 = 1\ns0 = 0\ntc = 1e-5\n[trajectory]\n[plot]\nkind = \"trajectories\"\nx = \"phase\"",
                        "\"column\"")),
      "x = 'phase' needs geometry = 'vibrated-column'");
}

TEST(VibratedSweep, CostGoesWithThePeriods) {
  for (const Method method : {Method::md, Method::ed}) {
    Parameters p = with(soft + "alpha = 2").at(0);
    p.method = method;
    const double before = predicted_time(p);
    p.periods *= 10;
    EXPECT_NEAR(predicted_time(p) / before, 10.0, 0.1);
    p.N *= 10;
    p.epsilon = 1.0 - 0.1 * (1.0 - p.epsilon);  // hard spheres do not collapse then
    EXPECT_GT(predicted_time(p), 100.0 * before);
  }
}
