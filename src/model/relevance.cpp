#include "sigmasweep/model/relevance.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "sigmasweep/model/geometry.hpp"
#include "sigmasweep/model/law.hpp"

namespace sigmasweep {
namespace {

bool is_soft(const Parameters& p) { return p.method == Method::md; }
bool has_gap(const Parameters& p) { return p.s0 > 0.0 || p.sigma > 0.0; }
bool is_shifted(const Parameters& p) { return p.random_separation == Flag::yes && has_gap(p); }
bool has_own_stiffness(const Parameters& p) { return p.K_over_m > 0.0 || p.material != Material::none; }
/// Hard spheres know only epsilon: the law counts where epsilon follows from it.
bool has_law(const Parameters& p) { return is_soft(p) || has_own_stiffness(p); }

bool is_linear(const Parameters& p) { return exponents(p).linear(); }

struct Rule {
  std::string_view name;
  bool (*applies_to)(const Parameters&);
  std::string_view needs;
};

bool by_contact(const Parameters& p) { return !has_own_stiffness(p); }
/// Hard spheres of the rule lrv have no contact time; what flies measures its gaps by it, with sigma.
bool has_contact_time(const Parameters& p) {
  return by_contact(p) && (!is_vibrated(p) || is_soft(p) || p.ed_rule == EdRule::tc);
}
/// What vibrates has no speed of its own, but laws that are not linear have tc and epsilon at one.
bool has_speed(const Parameters& p) { return !is_vibrated(p) || (has_law(p) && !is_linear(p)); }
bool has_overlaps(const Parameters& p) { return !is_vibrated(p) || is_soft(p); }
bool by_spring(const Parameters& p) { return p.K_over_m > 0.0 && p.material == Material::none; }
bool by_material(const Parameters& p) { return p.material != Material::none; }
bool has_own_diameter(const Parameters& p) { return p.material == Material::none; }
bool has_exponents(const Parameters& p) { return p.law == Law::power && has_law(p); }
bool has_fixed_steps(const Parameters& p) { return is_soft(p) && p.integrator != Integrator::exact; }
bool has_tolerance(const Parameters& p) { return is_soft(p) && !has_given_steps(p); }
bool is_hard(const Parameters& p) { return p.method == Method::ed; }
bool has_N(const Parameters& p) { return !is_lattice(p); }
bool is_random(const Parameters& p) { return p.width > 0.0 || is_shifted(p); }

constexpr auto rules = std::to_array<Rule>({
    {"N", has_N, "geometry = 'column' or 'vibrated-column'; of a lattice N = rows x columns, which are given instead"},
    {"v0", has_speed, "geometry = 'column' or 'lattice', or a law that is not linear"},
    {"tc", has_contact_time, "stiffness and damping given by tc and epsilon; of vibrated columns method = 'md'"},
    {"epsilon", by_contact, "stiffness and damping given by tc and epsilon"},
    {"K_over_m", by_spring, "stiffness and damping given by K_over_m and D_n"},
    {"D_n", by_spring, "stiffness and damping given by K_over_m and D_n"},
    {"material", by_material, "a material"},
    {"d", has_own_diameter, "beads of no material"},
    {"law", has_law, "method = 'md', or K_over_m or a material instead of epsilon"},
    {"beta", has_exponents, "law = 'power'"},
    {"gamma", has_exponents, "law = 'power'"},
    {"random_separation", has_gap, "a gap: s0 > 0 or sigma > 0"},
    {"seed", is_random, "width > 0, or random_separation = true and a gap"},
    {"ed_rule", is_hard, "method = 'ed'"},
    {"integrator", is_soft, "method = 'md'"},
    {"steps_per_tc", has_given_steps, "integrator = 'gear5', 'verlet' or 'rk4'"},
    {"predicted_growth", has_fixed_steps, "integrator = 'gear5', 'verlet' or 'rk4'"},
    {"x_max", has_overlaps, "geometry = 'column' or 'lattice', or method = 'md'"},
    {"tolerance", has_tolerance, "method = 'md', with integrator = 'exact' or without steps_per_tc"},
});

/// What only some geometries have, beside other rules.
constexpr auto of_what_flies = std::to_array<std::string_view>(
    {"sigma", "tolerance", "eps_eff", "eps_eff_error", "Er_Ef", "Er_E0", "v_cm", "t_k"});
constexpr auto of_what_vibrates = std::to_array<std::string_view>(
    {"gravity", "frequency", "alpha", "A0", "periods", "transient", "h_cm", "h_cm_error", "h_cm_excess", "E_r",
     "cm_period", "power_in", "power_lost", "imbalance"});
constexpr auto of_vibrated_columns = std::to_array<std::string_view>({"separation", "separation_max"});
constexpr auto of_lattices = std::to_array<std::string_view>({"rows", "columns", "D_t", "side_walls"});

struct Family {
  std::span<const std::string_view> fields;
  bool (*has)(const Parameters&);
  std::string_view needs;
};

constexpr auto families = std::to_array<Family>({
    {of_what_flies, [](const Parameters& p) { return !is_vibrated(p); }, "geometry = 'column' or 'lattice'"},
    {of_what_vibrates, is_vibrated, "geometry = 'vibrated-column' or 'vibrated-lattice'"},
    {of_vibrated_columns, [](const Parameters& p) { return p.geometry == Geometry::vibrated_column; },
     "geometry = 'vibrated-column'"},
    {of_lattices, is_lattice, "geometry = 'lattice' or 'vibrated-lattice'"},
});

const Family* family_of(const Field& field) {
  const auto family = std::ranges::find_if(
      families, [&](const Family& one) { return std::ranges::find(one.fields, field.name) != one.fields.end(); });
  return family == families.end() ? nullptr : &*family;
}

const Rule* rule_of(const Field& field) {
  const auto rule = std::ranges::find(rules, field.name, &Rule::name);
  return rule == rules.end() ? nullptr : &*rule;
}

}  // namespace

bool applies_to(const Field& field, const Parameters& tuple) {
  if (const Family* family = family_of(field); family && !family->has(tuple)) return false;
  const Rule* rule = rule_of(field);
  return rule == nullptr || rule->applies_to(tuple);
}

std::string requirement_of(const Field& field) {
  const Rule* rule = rule_of(field);
  std::string needs(rule == nullptr ? std::string_view{} : rule->needs);
  if (const Family* family = family_of(field))
    needs = std::string(family->needs) + (needs.empty() ? "" : ", and ") + needs;
  return needs;
}

bool has_given_steps(const Parameters& tuple) { return has_fixed_steps(tuple) && tuple.steps_per_tc > 0.0; }

}  // namespace sigmasweep
