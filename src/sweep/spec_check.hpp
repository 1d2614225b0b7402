#pragma once

#include <string_view>
#include <vector>

#include "sigmasweep/scene/parameters.hpp"
#include "spec_axis.hpp"

/// Checks that concern several settings of [sweep] together. All throw SpecError.
namespace sigmasweep::spec {

/// Names of axes that advance together.
using Zip = std::vector<std::string>;

const Setting* find(const std::vector<Setting>& settings, std::string_view name);
/// The zip that has `name`, or null.
const Zip* zip_of(const std::vector<Zip>& zips, std::string_view name);

/// Everything that a tuple needs is given: v0, tc, N, epsilon, and one of s0 and sigma. Where all tuples are hard
/// spheres tc may be left out.
void require_complete(const Entry& sweep, const std::vector<Setting>& settings);
/// Every parameter that is given is used by at least one tuple (before `where`).
void require_used(const std::vector<Setting>& settings, const std::vector<Zip>& zips);
/// s0 and sigma are both finite for all v0, tc that the axes span.
void require_finite_gap(const std::vector<Setting>& settings, const Parameters& base);

}  // namespace sigmasweep::spec
