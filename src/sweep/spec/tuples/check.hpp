#pragma once

#include <string_view>
#include <vector>

#include "sigmasweep/model/parameters.hpp"
#include "sweep/spec/tuples/axis.hpp"

/// Checks of which settings of [sweep] are given together. All throw SpecError.
namespace sigmasweep::spec {

/// Names of axes that advance together.
using Zip = std::vector<std::string>;

const Setting* find(const std::vector<Setting>& settings, std::string_view name);
/// The zip with the axis `name`, or null.
const Zip* zip_of(const std::vector<Zip>& zips, std::string_view name);

/// Requires that stiffness and damping are given in one way: tc and epsilon, K_over_m and D_n, or a material.
void require_one_way(const std::vector<Setting>& settings);
/// Requires all parameters that a tuple needs: v0; N, or rows of a lattice; stiffness and damping; s0 or sigma, or on a
/// plate alpha or A0; the exponents of a power law. `tuples` are representative_tuples().
void require_complete(const Entry& sweep, const std::vector<Setting>& settings, const std::vector<Parameters>& tuples);
/// Refuses a lattice of hard spheres.
void require_soft_lattice(const std::vector<Setting>& settings, const Parameters& tuple);
/// Requires that at least one tuple, before `where`, uses each parameter that is given.
void require_used(const std::vector<Setting>& settings, const std::vector<Parameters>& tuples);

}  // namespace sigmasweep::spec
