#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"

/// The one place where enumerators get the names that users write and read.
namespace sigmasweep {

/// The names of an enumeration's values, in the order of their numbers.
template <class Enum>
std::span<const std::string_view> names_of();

template <>
std::span<const std::string_view> names_of<Method>();
template <>
std::span<const std::string_view> names_of<Geometry>();
template <>
std::span<const std::string_view> names_of<Wall>();
template <>
std::span<const std::string_view> names_of<Integrator>();
template <>
std::span<const std::string_view> names_of<Law>();
template <>
std::span<const std::string_view> names_of<Material>();
template <>
std::span<const std::string_view> names_of<EdRule>();
template <>
std::span<const std::string_view> names_of<Flag>();
template <>
std::span<const std::string_view> names_of<SideWalls>();
template <>
std::span<const std::string_view> names_of<End>();
template <>
std::span<const std::string_view> names_of<Status>();

template <class Enum>
std::string_view name_of(Enum value) {
  return names_of<Enum>()[static_cast<std::size_t>(value)];
}

/// The value called `name`, if there is one.
template <class Enum>
std::optional<Enum> value_named(std::string_view name) {
  const auto names = names_of<Enum>();
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return static_cast<Enum>(i);
  return std::nullopt;
}

}  // namespace sigmasweep
