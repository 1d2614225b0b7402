#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "sigmasweep/model/geometry.hpp"
#include "sigmasweep/model/law.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"

/// Names of enumerators, as users write and read them. An enumeration registers its names beside itself, by a function
/// enumerator_names() of one value that returns them in the order of their numbers:
///
///     enum class Wall : std::uint8_t { paper, matched };
///     constexpr auto enumerator_names(Wall) { return names_up_to<Wall::matched>("paper", "matched"); }
namespace sigmasweep {

/// One name for each enumerator; does not compile where one is missing before `last`, the last enumerator.
template <auto last, class... Names>
constexpr auto names_up_to(Names... names) {
  static_assert(sizeof...(Names) == static_cast<std::size_t>(last) + 1, "one name for each enumerator");
  return std::array<std::string_view, sizeof...(Names)>{names...};
}

/// The names in a table of the model, whose entries {id, name, ...} stand in the order of the enumerators.
template <class Info, std::size_t n>
constexpr std::array<std::string_view, n> names_in(const std::array<Info, n>& table) {
  std::array<std::string_view, n> names{};
  for (std::size_t i = 0; i < n; ++i) {
    if (static_cast<std::size_t>(table[i].id) != i) throw "a table that is not in the order of its enumerators";
    names[i] = table[i].name;
  }
  return names;
}

// The enumerations of the model.
constexpr auto enumerator_names(Method) { return names_up_to<Method::ed>("md", "ed"); }
constexpr auto enumerator_names(SideWalls) { return names_up_to<SideWalls::fixed>("periodic", "fixed"); }
constexpr auto enumerator_names(Wall) { return names_up_to<Wall::matched>("paper", "matched"); }
constexpr auto enumerator_names(Integrator) {
  return names_up_to<Integrator::leapfrog>("exact", "gear5", "verlet", "rk4", "leapfrog");
}
constexpr auto enumerator_names(Material) { return names_up_to<Material::aluminium>("none", "steel", "aluminium"); }
constexpr auto enumerator_names(EdRule) { return names_up_to<EdRule::tc>("lrv", "tc"); }
constexpr auto enumerator_names(Flag) { return names_up_to<Flag::yes>("false", "true"); }
constexpr auto enumerator_names(End) {
  return names_up_to<End::quiet>("none", "separated", "settled", "periods", "quiet");
}
constexpr auto enumerator_names(Status) {
  return names_up_to<Status::quarantined>("ok", "collapsed", "tolerance_missed", "unstable", "event_limit",
                                          "time_limit", "non_finite", "failed", "not_run", "quarantined");
}
constexpr auto enumerator_names(Geometry) { return names_in(geometries); }
constexpr auto enumerator_names(Law) { return names_in(laws); }
static_assert(geometries.size() == static_cast<std::size_t>(Geometry::vibrated_lattice) + 1);
static_assert(laws.size() == static_cast<std::size_t>(Law::cone) + 1);

template <class Enum>
inline constexpr auto registered_names = enumerator_names(Enum{});

/// The names of an enumeration's values, in the order of their numbers.
template <class Enum>
constexpr std::span<const std::string_view> names_of() {
  static_assert(sizeof(Enum) == 1, "enumerations are stored in one byte");
  return registered_names<Enum>;
}

template <class Enum>
constexpr std::string_view name_of(Enum value) {
  return names_of<Enum>()[static_cast<std::size_t>(value)];
}

/// All values of an enumeration, in the order of their numbers.
template <class Enum>
constexpr auto values_of() {
  std::array<Enum, registered_names<Enum>.size()> values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<Enum>(i);
  return values;
}

/// The value called `name`, if there is one.
template <class Enum>
constexpr std::optional<Enum> value_named(std::string_view name) {
  const auto names = names_of<Enum>();
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return static_cast<Enum>(i);
  return std::nullopt;
}

}  // namespace sigmasweep
