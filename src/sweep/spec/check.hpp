#pragma once

#include <string_view>
#include <vector>

#include "sigmasweep/model/parameters.hpp"
#include "sweep/spec/axis.hpp"

/// Checks that concern several settings of [sweep] together. All throw SpecError.
namespace sigmasweep::spec {

/// Names of axes that advance together.
using Zip = std::vector<std::string>;

const Setting* find(const std::vector<Setting>& settings, std::string_view name);
/// The zip that has `name`, or null.
const Zip* zip_of(const std::vector<Zip>& zips, std::string_view name);

/// Stiffness and damping are given in one way: tc and epsilon, K_over_m and D_n, or a material.
void require_one_way(const std::vector<Setting>& settings);
/// Everything that a tuple needs is given: v0, N or of a lattice rows, stiffness and damping, one of s0 and sigma, the
/// exponents of a power law; of what vibrates alpha or A0, but no gap. What no tuple needs may be left out. `tuples`:
/// see representative_tuples().
void require_complete(const Entry& sweep, const std::vector<Setting>& settings, const std::vector<Parameters>& tuples);
/// The tuple is no lattice of hard spheres.
void require_soft_lattice(const std::vector<Setting>& settings, const Parameters& tuple);
/// Every parameter that is given is used by at least one tuple (before `where`).
void require_used(const std::vector<Setting>& settings, const std::vector<Parameters>& tuples);

}  // namespace sigmasweep::spec
