#include "sweep/repeat_command.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "model/fields/conditions.hpp"
#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/model/exact_number.hpp"
#include "sigmasweep/model/relevance.hpp"

namespace sigmasweep {
namespace {

/// Parameters that follow from others. Of s0 and sigma, and of alpha and A0, that one follows from which the other does
/// not follow to the bit.
std::vector<std::string_view> followers(const Parameters& given) {
  Parameters p = given;
  p.A0 = 0.0;
  derive_gap(p, GapParameter::s0);
  derive_plate_motion(p);
  std::vector<std::string_view> names{p.sigma == given.sigma ? "sigma" : "s0", p.A0 == given.A0 ? "A0" : "alpha"};
  const auto add = [&](std::initializer_list<std::string_view> more) { names.insert(names.end(), more); };
  if (given.material != Material::none)
    add({"tc", "epsilon", "K_over_m", "D_n", "d"});
  else if (given.K_over_m > 0.0)
    add({"tc", "epsilon"});
  if (conditions::lattice.holds(given)) add({"N"});
  return names;
}

/// Whether a parameter is typed even if it has its default.
bool is_needed(std::string_view name, const Parameters& p) {
  static constexpr auto always =
      std::to_array<std::string_view>({"v0", "tc", "s0", "sigma", "N", "rows", "epsilon", "beta", "gamma"});
  const bool chooses = name == "tolerance" && p.steps_per_tc == 0.0;  // the step, by being given
  return chooses || std::ranges::find(always, name) != always.end();
}

}  // namespace

std::string repeat_command(const Parameters& p) {
  const Parameters usual;
  const auto left_out = followers(p);
  std::string command = "sigmasweep one";
  for (const ParameterField& field : fields_of_parameters()) {
    if (std::ranges::find(left_out, field.name) != left_out.end() || !applies_to(*find_field(field.name), p)) continue;
    if (field.name == "steps_per_tc" && p.steps_per_tc == 0.0) continue;
    if (!is_needed(field.name, p) && exact_number(field, p) == exact_number(field, usual)) continue;
    std::string option(field.name);
    std::ranges::replace(option, '_', '-');
    command += fmt::format(" --{} {}", option, text(field, p));
  }
  return command;
}

}  // namespace sigmasweep
