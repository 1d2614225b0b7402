#include "studies/precision/text.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace sigmasweep {
namespace {

PrecisionRow row(std::uint64_t scene, Integrator integrator, double setting, double error, double seconds) {
  PrecisionRow row;
  row.scene = scene;
  row.parameters.integrator = integrator;
  row.setting = setting;
  row.tuples = row.compared = 10;
  row.error_max = error;
  row.run_time = seconds;
  return row;
}

TEST(PrecisionText, ClosesEachSceneWithTheFastestSettings) {
  std::vector<PrecisionRow> rows{
      row(0, Integrator::verlet, 20, 3e-3, 6e-6), row(0, Integrator::verlet, 100, 2e-4, 3e-5),
      row(0, Integrator::exact, 1e-9, 2e-15, 3.1e-5), row(1, Integrator::verlet, 20, 0.5, 6e-6)};
  rows.push_back(row(1, Integrator::verlet, 50, 1e-3, 1e-6));
  rows.back().failures = 1;  // of no use
  const std::string text = precision_text(rows, {});
  EXPECT_NE(text.find("  fastest with errors up to 1e-02: verlet tc/20, 6 us; 1e-04: exact 1e-09, 31 us; 1e-06: exact "
                      "1e-09, 31 us; 1e-09: exact 1e-09, 31 us\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("fastest", text.find("scene 1")), std::string::npos) << text;
}

}  // namespace
}  // namespace sigmasweep
