#include "sweep/spec/tuples/values.hpp"

#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>

#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/assembly/validity.hpp"
#include "sigmasweep/model/geometry.hpp"
#include "sweep/calibration_cache.hpp"

namespace sigmasweep::spec {
namespace {

constexpr std::uint64_t max_linear_pairs = 100'000;
constexpr std::uint64_t max_searched = 4096;  // values of an axis whose extremes are searched

/// The smallest and the largest value of a parameter.
std::array<double, 2> ends(const std::vector<Setting>& settings, std::string_view name, double otherwise) {
  const Setting* setting = find(settings, name);
  if (!setting) return {otherwise, otherwise};
  const auto [low, high] = setting->axis.bounds();
  return {static_cast<double>(low), static_cast<double>(high)};
}

double value_of(const Setting& setting, std::uint64_t k) { return static_cast<double>(setting.axis[k]); }

double largest(const Setting& setting) { return static_cast<double>(setting.axis.bounds().second); }

/// The one of s0 and sigma that is given; s0 if neither is, as may be with a plate.
const ParameterField& gap_of(const std::vector<Setting>& settings) {
  return *find_parameter(find(settings, "sigma") ? "sigma" : "s0");
}

GapParameter kind_of(const ParameterField& gap) { return gap.name == "s0" ? GapParameter::s0 : GapParameter::sigma; }

/// The values of a group at its ends and at the extremes of its axes.
ParameterGrid::Group extremes(const ParameterGrid::Group& group) {
  const std::uint64_t length = group.front().axis.size();
  std::set<std::uint64_t> places{0, length - 1};
  if (length <= max_searched)
    for (const ParameterGrid::Member& member : group) {
      std::uint64_t lowest = 0, highest = 0;
      for (std::uint64_t k = 1; k < length; ++k) {
        if (member.axis[k] < member.axis[lowest]) lowest = k;
        if (member.axis[k] > member.axis[highest]) highest = k;
      }
      places.insert({lowest, highest});
    }
  ParameterGrid::Group few;
  for (const ParameterGrid::Member& member : group) {
    std::vector<AnyNumber> values;
    for (const std::uint64_t k : places) values.push_back(member.axis[k]);
    few.push_back({member.field, Axis::list(std::move(values))});
  }
  return few;
}

bool has_names(const ParameterGrid::Group& group) {
  return std::ranges::any_of(group, [](const auto& member) { return !enumerators(member.field->type).empty(); });
}

/// The groups, reduced to their extremes one after the other until they make at most `max_pairs` pairs. Groups without
/// names are reduced first.
std::vector<ParameterGrid::Group> reduced_groups(std::vector<ParameterGrid::Group> few, std::uint64_t max_pairs) {
  const auto most = static_cast<double>(max_pairs);
  for (const bool names_too : {false, true})
    for (ParameterGrid::Group& group : few)
      if (count_of(few) > most && (names_too || !has_names(group))) group = extremes(group);
  return few;
}

}  // namespace

void require_diameters(const std::vector<Setting>& settings, const std::vector<Zip>& zips, const Parameters& base) {
  const Setting *width = find(settings, "width"), *d = find(settings, "d");
  if (!width) return;
  const auto check = [&](double w, double diameter) {
    Parameters p;
    p.width = w;
    p.d = diameter;
    if (const std::string why = why_invalid(p); !why.empty())
      refuse(width->entry, fmt::format("with d = {}: {}", diameter, why));
  };
  if (const Zip* zip = zip_of(zips, "width"); d && zip && zip == zip_of(zips, "d")) {
    const std::uint64_t last = width->axis.size() - 1;
    for (std::uint64_t k = 0; k < std::min(last, max_linear_pairs); ++k) check(value_of(*width, k), value_of(*d, k));
    return check(value_of(*width, last), value_of(*d, last));
  }
  Parameters beads = base;
  double smallest = ends(settings, "d", base.d)[0];
  if (const Setting* material = find(settings, "material")) {
    smallest = 1e300;
    for (std::uint64_t k = 0; k < material->axis.size(); ++k) {
      set_exact_number(*material->field, beads, material->axis[k]);
      beads.law = Law::hooke;  // the diameter does not depend on the law
      derive_material(beads);
      smallest = std::min(smallest, beads.d);
    }
  }
  check(largest(*width), smallest);
}

void require_lattice(const std::vector<Setting>& settings, const std::vector<Zip>& zips, const Parameters& base) {
  const Setting *rows = find(settings, "rows"), *columns = find(settings, "columns");
  if (!rows) return;
  const auto check = [&](double high, double wide) {
    Parameters p;
    p.geometry = Geometry::lattice;
    p.rows = static_cast<std::int64_t>(high);
    p.columns = static_cast<std::int64_t>(wide);
    derive_beads(p);
    if (const std::string why = why_invalid(p); !why.empty()) refuse((columns ? columns : rows)->entry, why);
  };
  if (const Zip* zip = zip_of(zips, "rows"); columns && zip && zip == zip_of(zips, "columns"))
    for (std::uint64_t k = 0; k < std::min(rows->axis.size(), max_linear_pairs); ++k)
      check(value_of(*rows, k), value_of(*columns, k));
  else
    check(largest(*rows), ends(settings, "columns", static_cast<double>(base.columns))[1]);
}

void require_plate(const std::vector<Setting>& settings, const std::vector<Zip>& zips, const Parameters& base) {
  const Setting* given = find(settings, find(settings, "A0") ? "A0" : "alpha");
  if (!given) return;
  Parameters p;
  p.geometry = Geometry::vibrated_column;
  for (const double gravity : ends(settings, "gravity", base.gravity))
    for (const double frequency : ends(settings, "frequency", base.frequency))
      for (const double value : ends(settings, given->field->name, 0.0)) {
        p.gravity = gravity;
        p.frequency = frequency;
        p.alpha = p.A0 = 0.0;
        set_number(*given->field, p, value);
        derive_plate_motion(p);
        if (const std::string why = why_invalid(p); !why.empty())
          refuse(given->entry, fmt::format("with gravity = {}, frequency = {} and {} = {}: {}", gravity, frequency,
                                           given->field->name, value, why));
      }
  const Setting *periods = find(settings, "periods"), *transient = find(settings, "transient");
  const auto check = [&](double all, double first) {
    if (first >= all)
      refuse((transient ? transient : periods)->entry,
             fmt::format("a transient of {} periods must be shorter than all {} periods", first, all));
  };
  if (const Zip* zip = zip_of(zips, "periods"); transient && zip && zip == zip_of(zips, "transient"))
    for (std::uint64_t k = 0; k < std::min(periods->axis.size(), max_linear_pairs); ++k)
      check(value_of(*periods, k), value_of(*transient, k));
  else
    check(ends(settings, "periods", static_cast<double>(base.periods))[0],
          ends(settings, "transient", static_cast<double>(base.transient))[1]);
}

void require_finite_gap(const std::vector<Setting>& settings, const Parameters& base, bool of_lattice) {
  if (find(settings, "K_over_m") || find(settings, "material")) return;
  // sigma and s0 are monotonic in v0, tc and each other, so that their extremes are at the ends of the axes.
  const Setting* gap = find(settings, gap_of(settings).name);
  if (!gap) return;
  const Setting& given = *gap;
  for (const double v0 : ends(settings, "v0", base.v0))
    for (const double tc : ends(settings, "tc", base.tc))
      for (const double value : ends(settings, given.field->name, 0.0)) {
        Parameters p;
        p.v0 = v0;
        p.tc = tc;
        set_number(*given.field, p, value);
        if (of_lattice) {
          p.geometry = Geometry::lattice;
          p.rows = static_cast<std::int64_t>(ends(settings, "rows", static_cast<double>(base.rows))[1]);
          derive_beads(p);
        }
        if (const std::string why = why_invalid(complete(p, kind_of(*given.field))); !why.empty())
          refuse(given.entry,
                 fmt::format("with v0 = {}, tc = {} and {} = {}: {}", v0, tc, given.field->name, value, why));
      }
}

void require_pairs(const std::vector<Setting>& settings, const ParameterGrid& product) {
  const Setting* stiffness = find(settings, "K_over_m");
  if (!stiffness) stiffness = find(settings, "material");
  if (!stiffness) return;
  const ParameterField& gap = gap_of(settings);
  const bool linear = !find(settings, "law") || largest(*find(settings, "law")) == 0.0;
  static_assert(static_cast<int>(Law::hooke) == 0);
  const Parameters& base = product.base();
  const auto few = reduced_groups(groups_of_pairs(base, product.groups(), product.dependents()),
                                  linear ? max_linear_pairs : CalibrationCache::max_pairs);
  for (std::uint64_t i = 0; i < size_of(few); ++i) {
    Parameters pair = values_at(base, few, i);
    product.dependents().set(pair);
    product.contacts().derive_contact(pair);
    for (const double value : ends(settings, gap.name, 0.0)) {
      Parameters p = pair;
      p.width = 0.0;  // checked by require_diameters(), and the plate by require_plate()
      p.geometry = Geometry::column;
      set_number(gap, p, value);
      derive_gap(p, kind_of(gap));
      if (const std::string why = why_invalid(p); !why.empty())
        refuse(stiffness->entry, fmt::format("with v0 = {} and {} = {}: {}", p.v0, gap.name, value, why));
    }
  }
}

}  // namespace sigmasweep::spec
