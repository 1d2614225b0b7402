#include "sweep/spec/tuples/base.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "sweep/spec/tuples/check.hpp"

namespace sigmasweep::spec {

Parameters base_of(const std::vector<Setting>& settings) {
  Parameters base;
  const Setting* integrator = find(settings, "integrator");
  if (integrator && integrator->axis.bounds().second > 0.0 && find(settings, "tolerance"))
    base.steps_per_tc = 0.0;  // the step is chosen for the tolerance, unless steps_per_tc is given
  static_assert(static_cast<int>(Integrator::exact) == 0);
  for (const Setting& setting : settings) set_exact_number(*setting.field, base, setting.axis[0]);
  return base;
}

bool has_default(const ParameterField& field) {
  static constexpr auto without = std::to_array<std::string_view>(
      {"v0", "tc", "s0", "sigma", "N", "epsilon", "K_over_m", "beta", "gamma", "rows", "alpha", "A0"});
  return std::ranges::find(without, field.name) == without.end();
}

}  // namespace sigmasweep::spec
