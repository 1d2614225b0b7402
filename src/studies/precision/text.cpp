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

std::string setting_of(const PrecisionRow& row) {
  const bool exact = row.parameters.integrator == Integrator::exact;
  return exact ? shown(row.setting, "{:.0e}") : fmt::format("tc/{:g}", row.setting);
}

/// The setting of least time with no error above `error`, without a failure; null if there is none.
const PrecisionRow* fastest(std::span<const PrecisionRow> scene, double error) {
  const PrecisionRow* best = nullptr;
  for (const PrecisionRow& row : scene)
    if (row.tuples > 0 && row.failures == 0 && row.error_max <= error && row.run_time > 0.0 &&
        (best == nullptr || row.run_time < best->run_time))
      best = &row;
  return best;
}

/// "  fastest with errors up to 1e-02: verlet tc/20, 6.1 us; 1e-09: exact 1e-09, 31 us"; empty without measurements.
std::string verdict(std::span<const PrecisionRow> scene) {
  std::string line;
  for (const double error : {1e-2, 1e-4, 1e-6, 1e-9}) {
    const PrecisionRow* best = fastest(scene, error);
    if (best == nullptr) continue;
    line += fmt::format("{}{:.0e}: {} {}, {:.3g} us", line.empty() ? "  fastest with errors up to " : "; ", error,
                        name_of(best->parameters.integrator), setting_of(*best), 1e6 * best->run_time);
  }
  return line.empty() ? "" : line + "\n";
}

/// The rows of the same scene from the first one on.
std::span<const PrecisionRow> scene_of(std::span<const PrecisionRow> rows) {
  std::size_t count = 0;
  while (count < rows.size() && rows[count].scene == rows[0].scene) ++count;
  return rows.first(count);
}

std::string line_of(const PrecisionRow& row) {
  const std::string line = fmt::format("  {:<10} {:>9} ", name_of(row.parameters.integrator), setting_of(row));
  if (row.tuples == 0) return line + "left out: a tuple would take too long\n";
  return line + fmt::format("{:>7} {:>7} {:>8} {:>9} {:>9} {:>9} {:>9} {:>11} {:>12}\n", row.tuples, row.failures,
                            row.compared, shown(row.error_median, "{:.1e}"), shown(row.error_99, "{:.1e}"),
                            shown(row.error_max, "{:.1e}"), shown(row.velocity_max, "{:.1e}"),
                            shown(1e6 * row.run_time, "{:.1f}"), shown(row.evaluations, "{:.0f}"));
}

}  // namespace

std::string precision_text(std::span<const PrecisionRow> rows, std::span<const std::string> axes) {
  std::string out;
  for (std::span<const PrecisionRow> left = rows; !left.empty();) {
    const auto scene = scene_of(left);
    out += fmt::format("{}{}\n{}\n  {:<10} {:>9} {:>7} {:>7} {:>8} {:>9} {:>9} {:>9} {:>9} {:>11} {:>12}\n",
                       out.empty() ? "" : "\n", scene_line(scene[0], axes), reference_line(scene[0]), "integrator",
                       "setting", "tuples", "failed", "compared", "median", "99 %", "max", "max v", "us/tuple",
                       "force evals");
    for (const PrecisionRow& row : scene) out += line_of(row);
    out += verdict(scene);
    left = left.subspan(scene.size());
  }
  return out;
}

}  // namespace sigmasweep
