#include "spec_check.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "sigmasweep/errors.hpp"
#include "sigmasweep/scene/names.hpp"

namespace sigmasweep::spec {
namespace {

/// Which combinations of method and integrator occur.
class Combinations {
 public:
  Combinations(const std::vector<Setting>& settings, const std::vector<Zip>& zips) {
    const Setting* method = find(settings, "method");
    const Setting* integrator = find(settings, "integrator");
    const Zip* zip = zip_of(zips, "method");
    if (method && integrator && zip && zip == zip_of(zips, "integrator")) {
      for (std::uint64_t k = 0; k < method->axis.size(); ++k) seen_[at(method, k)][at(integrator, k)] = true;
      return;
    }
    for (std::uint64_t m = 0; m < length(method); ++m) seen_[at(method, m)][0] = true;
    std::array<bool, 4> integrators{};
    for (std::uint64_t i = 0; i < length(integrator); ++i) integrators[at(integrator, i)] = true;
    for (auto& row : seen_)
      if (row[0]) row = integrators;
  }

  bool soft() const { return exact() || fixed_step(); }
  bool exact() const { return soft_row()[0]; }
  bool fixed_step() const {
    return std::any_of(soft_row().begin() + 1, soft_row().end(), [](bool seen) { return seen; });
  }

 private:
  static std::uint64_t length(const Setting* setting) { return setting ? setting->axis.size() : 1; }
  /// The number of the k-th enumerator; the defaults are number 0.
  static std::size_t at(const Setting* setting, std::uint64_t k) {
    return setting ? static_cast<std::size_t>(setting->axis[k]) : 0;
  }
  const std::array<bool, 4>& soft_row() const { return seen_[static_cast<std::size_t>(Method::md)]; }

  static_assert(static_cast<int>(Method::md) == 0 && static_cast<int>(Integrator::exact) == 0);
  std::array<std::array<bool, 4>, 2> seen_{};
};

bool only_hard_spheres(const std::vector<Setting>& settings) {
  const Setting* method = find(settings, "method");
  return method != nullptr && method->axis.bounds().first == static_cast<double>(Method::ed);
}

}  // namespace

const Setting* find(const std::vector<Setting>& settings, std::string_view name) {
  for (const Setting& setting : settings)
    if (setting.field->name == name) return &setting;
  return nullptr;
}

const Zip* zip_of(const std::vector<Zip>& zips, std::string_view name) {
  for (const Zip& zip : zips)
    if (std::find(zip.begin(), zip.end(), name) != zip.end()) return &zip;
  return nullptr;
}

void require_complete(const Entry& sweep, const std::vector<Setting>& settings) {
  for (const std::string_view name : {"v0", "tc", "N", "epsilon"}) {
    if (find(settings, name) || (name == "tc" && only_hard_spheres(settings))) continue;
    refuse(sweep, fmt::format("'{}' is missing: v0, tc, N, epsilon and one of s0 and sigma are needed", name));
  }
  const Setting* s0 = find(settings, "s0");
  const Setting* sigma = find(settings, "sigma");
  if (!s0 && !sigma) refuse(sweep, "one of 's0' and 'sigma' is missing");
  if (s0 && sigma)
    refuse((s0->entry.line > sigma->entry.line ? s0 : sigma)->entry,
           "give s0 or sigma, not both: sigma = s0/(v0 tc)");
}

void require_used(const std::vector<Setting>& settings, const std::vector<Zip>& zips) {
  const Combinations seen(settings, zips);
  struct Need {
    std::string_view name;
    bool met;
    std::string_view what;
  };
  for (const Need& need : {Need{"integrator", seen.soft(), "method = 'md'"},
                           Need{"steps_per_tc", seen.fixed_step(), "integrator = 'gear5', 'verlet' or 'rk4'"},
                           Need{"tolerance", seen.exact(), "method = 'md' with integrator = 'exact'"}})
    if (const Setting* setting = find(settings, need.name); setting && !need.met)
      refuse(setting->entry, fmt::format("no tuple uses it: it needs {}", need.what));
}

void require_finite_gap(const std::vector<Setting>& settings, const Parameters& base) {
  // sigma and s0 are monotonic in v0, tc and each other: the corners of the box that the axes span are the extremes.
  const auto ends = [&](std::string_view name, double otherwise) {
    const Setting* setting = find(settings, name);
    const auto [low, high] = setting ? setting->axis.bounds() : std::pair{otherwise, otherwise};
    return std::array{low, high};
  };
  const Setting* s0 = find(settings, "s0");
  const Gap gap = s0 ? Gap::s0 : Gap::sigma;
  const Setting& given = s0 ? *s0 : *find(settings, "sigma");
  for (const double v0 : ends("v0", base.v0))
    for (const double tc : ends("tc", base.tc))
      for (const double value : ends(given.field->name, 0.0)) {
        Row row;
        row.parameters.v0 = v0;
        row.parameters.tc = tc;
        set_number(*given.field, row, value);
        if (const std::string why = why_invalid(complete(row.parameters, gap)); !why.empty())
          refuse(given.entry,
                 fmt::format("with v0 = {}, tc = {} and {} = {}: {}", v0, tc, given.field->name, value, why));
      }
}

}  // namespace sigmasweep::spec
