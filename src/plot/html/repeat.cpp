#include "plot/html/repeat.hpp"

#include <algorithm>
#include <string_view>

#include "model/fields/conditions.hpp"
#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/relevance.hpp"

namespace sigmasweep::plot {
namespace {

/// Parameters that follow from others, so that they are not typed: a collision depends on sigma, s0 follows from it.
bool follows(const Parameters& p, std::string_view name) {
  const bool of_material = p.material != Material::none;
  if (name == "s0") return p.frequency == Parameters{}.frequency || !(p.alpha > 0.0);
  if (name == "sigma") return p.alpha > 0.0;
  if (name == "A0") return true;
  if (name == "tc" || name == "epsilon") return p.K_over_m > 0.0;
  if (name == "K_over_m" || name == "D_n" || name == "d") return of_material;
  if (name == "N") return conditions::lattice.holds(p);  // rows times columns
  return false;
}

bool is_needed(std::string_view name) {
  return name == "v0" || name == "tc" || name == "sigma" || name == "N" || name == "epsilon" || name == "rows" ||
         name == "alpha" || name == "K_over_m";
}

}  // namespace

std::string command_of(const Parameters& p) {
  std::string command = "sigmasweep one";
  const Parameters usual;
  for (const ParameterField& field : fields_of_parameters()) {
    if (follows(p, field.name) || !applies_to(*find_field(field.name), p)) continue;
    if (field.name == "K_over_m" && !(p.K_over_m > 0.0)) continue;
    const std::string value = text(field, p);
    if (value == text(field, usual) && !is_needed(field.name)) continue;
    std::string name(field.name);
    std::ranges::replace(name, '_', '-');
    command += " --" + name + " " + value;
  }
  return command;
}

}  // namespace sigmasweep::plot
