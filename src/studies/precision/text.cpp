#include "studies/precision/text.hpp"

#include <fmt/format.h>

#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/names.hpp"
#include "studies/precision/measure.hpp"

namespace sigmasweep {
namespace {

std::string scene_line(const PrecisionRow& row, std::span<const std::string> axes) {
  Row scene;
  scene.parameters = row.parameters;
  std::string line;
  for (const std::string& axis : axes)
    if (const Field* field = find_field(axis))
      line += fmt::format("{}{} = {}", line.empty() ? "" : ", ", axis, text(*field, scene));
  return line.empty() ? fmt::format("scene {}", row.scene) : line;
}

/// "errors of eps_eff; references: 400; 20 checked by another method, which agrees to 2e-17"
std::string reference_line(const PrecisionRow& row) {
  std::string line = fmt::format("  errors of {}; references: {}; {} checked by {}", precision_quantity(row.parameters),
                                 row.references, row.checks,
                                 row.independent != 0 ? "another method"
                                                      : "the same method at another accuracy "
                                                        "(less independent)");
  if (row.checks > row.chaotic) line += fmt::format(", which agrees to {:.1e}", row.noise);
  if (row.chaotic > 0)
    line += fmt::format("; CHAOTIC: {} of them differ by more than 1e-9, only the others are compared", row.chaotic);
  return line;
}

std::string shown(double value, const char* format) {
  return value == value ? fmt::format(fmt::runtime(format), value) : "-";
}

}  // namespace

std::string precision_text(std::span<const PrecisionRow> rows, std::span<const std::string> axes) {
  std::string out;
  const PrecisionRow* before = nullptr;
  for (const PrecisionRow& row : rows) {
    if (before == nullptr || before->scene != row.scene)
      out += fmt::format("{}{}\n{}\n  {:<10} {:>9} {:>7} {:>7} {:>8} {:>9} {:>9} {:>9} {:>9} {:>11} {:>12}\n",
                         before ? "\n" : "", scene_line(row, axes), reference_line(row), "integrator", "setting",
                         "tuples", "failed", "compared", "median", "99 %", "max", "max v", "us/tuple", "force evals");
    before = &row;
    const bool exact = row.parameters.integrator == Integrator::exact;
    const std::string setting = exact ? shown(row.setting, "{:.0e}") : fmt::format("tc/{:g}", row.setting);
    out += fmt::format("  {:<10} {:>9} ", name_of(row.parameters.integrator), setting);
    if (row.tuples == 0) {
      out += "left out: a tuple would take too long\n";
      continue;
    }
    out += fmt::format("{:>7} {:>7} {:>8} {:>9} {:>9} {:>9} {:>9} {:>11} {:>12}\n", row.tuples, row.failures,
                       row.compared, shown(row.error_median, "{:.1e}"), shown(row.error_99, "{:.1e}"),
                       shown(row.error_max, "{:.1e}"), shown(row.velocity_max, "{:.1e}"),
                       shown(1e6 * row.run_time, "{:.1f}"), shown(row.evaluations, "{:.0f}"));
  }
  return out;
}

}  // namespace sigmasweep
