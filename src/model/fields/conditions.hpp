#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/geometry.hpp"
#include "sigmasweep/model/law.hpp"
#include "sigmasweep/model/names.hpp"

/// Conditions for a tuple to use a field: on its geometry, its contact law and its solver.
namespace sigmasweep::conditions {

inline constexpr Condition always{[](const Parameters&) { return true; }, ""};

// By geometry.

inline constexpr Condition flies{[](const Parameters& p) { return !is_vibrated(p); },
                                 "geometry = 'column' or 'lattice'"};
inline constexpr Condition vibrates{is_vibrated, "geometry = 'vibrated-column' or 'vibrated-lattice'"};
inline constexpr Condition vibrated_column{[](const Parameters& p) { return is_vibrated(p) && !is_lattice(p); },
                                           "geometry = 'vibrated-column'"};
inline constexpr Condition lattice{is_lattice, "geometry = 'lattice' or 'vibrated-lattice'"};
inline constexpr Condition column{
    [](const Parameters& p) { return !is_lattice(p); },
    "geometry = 'column' or 'vibrated-column'; of a lattice N = rows x columns, which are given instead"};

// By the parameters that give stiffness and damping of a contact.

/// Whether K_over_m or a material is given, from which tc and epsilon follow.
constexpr bool has_own_stiffness(const Parameters& p) { return p.K_over_m > 0.0 || p.material != Material::none; }
constexpr bool is_soft(const Parameters& p) { return p.method == Method::md; }
/// Whether the tuple uses the law. Hard spheres need epsilon only, and the law if epsilon follows from it.
constexpr bool has_law(const Parameters& p) { return is_soft(p) || has_own_stiffness(p); }

inline constexpr Condition by_contact{[](const Parameters& p) { return !has_own_stiffness(p); },
                                      "stiffness and damping given by tc and epsilon"};
/// Whether tc has a meaning and stands in the table, given or derived.
inline constexpr Condition tabulated_contact_time{
    [](const Parameters& p) { return !is_vibrated(p) || is_soft(p) || p.ed_rule == EdRule::tc; }, ""};
/// Whether tc can be given. Hard spheres of the rule lrv have no contact time, but without gravity tc is the unit of
/// sigma.
inline constexpr Condition contact_time{
    [](const Parameters& p) { return by_contact.holds(p) && tabulated_contact_time.holds(p); },
    "stiffness and damping given by tc and epsilon; of vibrated columns method = 'md'"};
inline constexpr Condition by_spring{
    [](const Parameters& p) { return p.K_over_m > 0.0 && p.material == Material::none; },
    "stiffness and damping given by K_over_m and D_n"};
inline constexpr Condition by_material{[](const Parameters& p) { return p.material != Material::none; }, "a material"};
inline constexpr Condition own_diameter{[](const Parameters& p) { return p.material == Material::none; },
                                        "beads of no material"};
inline constexpr Condition law{has_law, "method = 'md', or K_over_m or a material instead of epsilon"};
inline constexpr Condition free_exponents{
    [](const Parameters& p) { return laws[static_cast<std::size_t>(p.law)].free_exponents && has_law(p); },
    "law = 'power'"};
/// Whether v0 can be given. Vibrated beads have no approach speed, but nonlinear laws have tc and epsilon at v0.
inline constexpr Condition speed{
    [](const Parameters& p) { return !is_vibrated(p) || (has_law(p) && !exponents(p).linear()); },
    "geometry = 'column' or 'lattice', or a law that is not linear"};

// By the initial state.

constexpr bool has_gap(const Parameters& p) { return p.s0 > 0.0 || p.sigma > 0.0; }
inline constexpr Condition gap{has_gap, "a gap: s0 > 0 or sigma > 0"};
inline constexpr Condition random{
    [](const Parameters& p) { return p.width > 0.0 || (p.random_separation == Flag::yes && has_gap(p)); },
    "width > 0, or random_separation = true and a gap"};

// By the solver.

inline constexpr Condition soft{is_soft, "method = 'md'"};
inline constexpr Condition hard{[](const Parameters& p) { return !is_soft(p); }, "method = 'ed'"};
inline constexpr Condition overlaps{[](const Parameters& p) { return !is_vibrated(p) || is_soft(p); },
                                    "geometry = 'column' or 'lattice', or method = 'md'"};

/// A text that is put together while the program is compiled.
struct ConstantText {
  std::array<char, 128> characters{};
  std::size_t size = 0;

  constexpr void add(std::string_view text) {
    for (const char character : text) characters[size++] = character;
  }
  constexpr std::string_view view() const { return {characters.data(), size}; }
};

/// "integrator = 'gear5', 'verlet' or ...": all integrators but exact.
inline constexpr ConstantText fixed_step_integrator = [] {
  ConstantText text;
  text.add("integrator = ");
  const auto names = names_of<Integrator>();
  for (std::size_t i = 1; i < names.size(); ++i) {
    text.add(i == 1 ? "'" : i + 1 < names.size() ? ", '" : " or '");
    text.add(names[i]);
    text.add("'");
  }
  return text;
}();
static_assert(Integrator::exact == Integrator{});

inline constexpr Condition fixed_steps{
    [](const Parameters& p) { return is_soft(p) && p.integrator != Integrator::exact; }, fixed_step_integrator.view()};
inline constexpr Condition given_steps{[](const Parameters& p) { return fixed_steps.holds(p) && p.steps_per_tc > 0.0; },
                                       fixed_step_integrator.view()};
inline constexpr Condition chosen_steps{
    [](const Parameters& p) { return fixed_steps.holds(p) && !(p.steps_per_tc > 0.0); },
    "an integrator of fixed step and a tolerance instead of steps_per_tc"};
inline constexpr Condition tolerance{[](const Parameters& p) { return is_soft(p) && !given_steps.holds(p); },
                                     "method = 'md', with integrator = 'exact' or without steps_per_tc"};

}  // namespace sigmasweep::conditions
