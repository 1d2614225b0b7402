#include "sigmasweep/model/names.hpp"

#include "sigmasweep/model/geometry.hpp"
#include "sigmasweep/model/law.hpp"

namespace sigmasweep {
namespace {

using std::string_view;

/// The names in a table of the model, which stands in the order of the enumerators.
template <class Info, std::size_t n>
constexpr std::array<string_view, n> names_in(const std::array<Info, n>& table) {
  std::array<string_view, n> names{};
  for (std::size_t i = 0; i < n; ++i) {
    if (static_cast<std::size_t>(table[i].id) != i) throw "a table that is not in the order of its enumerators";
    names[i] = table[i].name;
  }
  return names;
}
constexpr auto geometry_names = names_in(geometries);
constexpr auto law_names = names_in(laws);

constexpr std::array<string_view, 2> method_names{"md", "ed"};
constexpr std::array<string_view, 2> side_walls_names{"periodic", "fixed"};
constexpr std::array<string_view, 2> wall_names{"paper", "matched"};
constexpr std::array<string_view, 4> integrator_names{"exact", "gear5", "verlet", "rk4"};
constexpr std::array<string_view, 3> material_names{"none", "steel", "aluminium"};
constexpr std::array<string_view, 2> ed_rule_names{"lrv", "tc"};
constexpr std::array<string_view, 2> flag_names{"false", "true"};
constexpr std::array<string_view, 5> end_names{"none", "separated", "settled", "periods", "quiet"};
constexpr std::array<string_view, 10> status_names{"ok",          "collapsed",  "tolerance_missed", "unstable",
                                                   "event_limit", "time_limit", "non_finite",       "failed",
                                                   "not_run",     "quarantined"};

// One name an enumerator: a new enumerator without a name does not compile.
static_assert(method_names.size() == static_cast<std::size_t>(Method::ed) + 1);
static_assert(geometry_names.size() == static_cast<std::size_t>(Geometry::vibrated_lattice) + 1);
static_assert(side_walls_names.size() == static_cast<std::size_t>(SideWalls::fixed) + 1);
static_assert(wall_names.size() == static_cast<std::size_t>(Wall::matched) + 1);
static_assert(integrator_names.size() == static_cast<std::size_t>(Integrator::rk4) + 1);
static_assert(law_names.size() == static_cast<std::size_t>(Law::power) + 1);
static_assert(material_names.size() == static_cast<std::size_t>(Material::aluminium) + 1);
static_assert(ed_rule_names.size() == static_cast<std::size_t>(EdRule::tc) + 1);
static_assert(flag_names.size() == static_cast<std::size_t>(Flag::yes) + 1);
static_assert(end_names.size() == static_cast<std::size_t>(End::quiet) + 1);
static_assert(status_names.size() == static_cast<std::size_t>(Status::quarantined) + 1);

}  // namespace

template <>
std::span<const string_view> names_of<Method>() {
  return method_names;
}
template <>
std::span<const string_view> names_of<Geometry>() {
  return geometry_names;
}
template <>
std::span<const string_view> names_of<Wall>() {
  return wall_names;
}
template <>
std::span<const string_view> names_of<Integrator>() {
  return integrator_names;
}
template <>
std::span<const string_view> names_of<Law>() {
  return law_names;
}
template <>
std::span<const string_view> names_of<Material>() {
  return material_names;
}
template <>
std::span<const string_view> names_of<EdRule>() {
  return ed_rule_names;
}
template <>
std::span<const string_view> names_of<Flag>() {
  return flag_names;
}
template <>
std::span<const string_view> names_of<SideWalls>() {
  return side_walls_names;
}
template <>
std::span<const string_view> names_of<End>() {
  return end_names;
}
template <>
std::span<const string_view> names_of<Status>() {
  return status_names;
}

}  // namespace sigmasweep
