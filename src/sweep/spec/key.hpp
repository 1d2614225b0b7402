#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "sweep/spec/entry.hpp"
#include "sweep/toml/mistakes.hpp"

/// Keys of the spec's tables: how each is read, and how help, the reference and the JSON schema show it.
namespace sigmasweep::spec {

/// The form of a key's value.
enum class KeyForm {
  text,
  number,
  whole_number,
  truth,
  choice,
  fields,
  expression,
  condition,
  point,
  numbers,
  choices,
  groups,
  names,  ///< a list of parameters
  table,
  tables,         ///< a list of tables
  one_or_several  ///< a table, or a list of tables
};

/// A key as it is shown.
struct KeyInfo {
  std::string_view name;
  KeyForm form = KeyForm::text;
  std::string_view meaning;                     ///< one line
  std::string_view usual{};                     ///< the default; empty: none
  std::span<const std::string_view> choices{};  ///< of KeyForm::choice and choices
  std::vector<KeyInfo> (*keys)() = nullptr;     ///< of KeyForm::table and tables
  bool also_number = false;                     ///< an expression that may be a number
};

/// A key of a table that is read into a Spec.
template <class Spec>
struct Key {
  KeyInfo info;
  void (*read)(const Entry& entry, Spec& spec);
};

template <class Spec, std::size_t n>
std::vector<KeyInfo> infos_of(const std::array<Key<Spec>, n>& keys) {
  std::vector<KeyInfo> infos;
  for (const Key<Spec>& key : keys) infos.push_back(key.info);
  return infos;
}

/// Reads the keys of a table in the order of the file. Throws a SpecError with the mistakes of all of them.
template <class Spec, std::size_t n>
void read_keys(const Entry& table, const std::array<Key<Spec>, n>& keys, Spec& spec) {
  Mistakes mistakes;
  const auto read = [&](const Entry& entry) {
    for (const Key<Spec>& key : keys)
      if (key.info.name == entry.name) return key.read(entry, spec);
    std::array<std::string_view, n> names;
    std::ranges::transform(keys, names.begin(), [](const Key<Spec>& key) { return key.info.name; });
    refuse_unknown(entry, names);
  };
  for (const Entry& entry : entries(as_table(table), *table.file, table.path)) mistakes.keep([&] { read(entry); });
  mistakes.refuse_any();
}

}  // namespace sigmasweep::spec
