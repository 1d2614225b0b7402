#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

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
