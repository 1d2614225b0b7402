#include "sigmasweep/sweep/usage.hpp"

#include <algorithm>
#include <array>

namespace sigmasweep {
namespace {

bool is_soft(const Parameters& p) { return p.method == Method::md; }
bool has_gap(const Parameters& p) { return p.s0 > 0.0 || p.sigma > 0.0; }
bool is_shifted(const Parameters& p) { return p.random_separation == Flag::yes && has_gap(p); }
bool has_own_stiffness(const Parameters& p) { return p.K_over_m > 0.0 || p.material != Material::none; }
/// Hard spheres know only epsilon: the law counts where epsilon follows from it.
bool has_law(const Parameters& p) { return is_soft(p) || has_own_stiffness(p); }

struct Rule {
  std::string_view name;
  bool (*is_used)(const Parameters&);
  std::string_view needs;
};

bool by_contact(const Parameters& p) { return !has_own_stiffness(p); }
bool by_spring(const Parameters& p) { return p.K_over_m > 0.0 && p.material == Material::none; }
bool by_material(const Parameters& p) { return p.material != Material::none; }
bool has_own_diameter(const Parameters& p) { return p.material == Material::none; }
bool has_exponents(const Parameters& p) { return p.law == Law::power && has_law(p); }
bool has_fixed_steps(const Parameters& p) { return is_soft(p) && p.integrator != Integrator::exact; }
bool has_given_steps(const Parameters& p) { return has_fixed_steps(p) && p.steps_per_tc > 0.0; }
bool has_tolerance(const Parameters& p) { return is_soft(p) && !has_given_steps(p); }
bool is_hard(const Parameters& p) { return p.method == Method::ed; }
bool is_random(const Parameters& p) { return p.width > 0.0 || is_shifted(p); }

constexpr auto rules = std::to_array<Rule>({
    {"tc", by_contact, "stiffness and damping given by tc and epsilon"},
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
    {"tolerance", has_tolerance, "method = 'md', with integrator = 'exact' or without steps_per_tc"},
});

const Rule* rule_of(const Field& field) {
  const auto rule = std::ranges::find(rules, field.name, &Rule::name);
  return rule == rules.end() ? nullptr : &*rule;
}

}  // namespace

bool is_used(const Field& field, const Parameters& tuple) {
  const Rule* rule = rule_of(field);
  return rule == nullptr || rule->is_used(tuple);
}

std::string_view needed_for(const Field& field) {
  const Rule* rule = rule_of(field);
  return rule == nullptr ? std::string_view{} : rule->needs;
}

}  // namespace sigmasweep
