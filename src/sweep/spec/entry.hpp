#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

/// Keys of a spec in TOML with their values and places, and the messages about bad ones.
namespace sigmasweep::spec {

/// A key of the spec with its value. It refers to the parsed document and to the name of the file, which must exist as
/// long.
struct Entry {
  const std::string* file = nullptr;
  std::string path;                  ///< such as sweep.s0.from
  std::string_view name;             ///< the last part of the path
  const toml::node* node = nullptr;  ///< the value
  toml::source_index line = 0;       ///< 0 if unknown
};

/// The keys of a table in the order of the file.
std::vector<Entry> entries(const toml::table& table, const std::string& file, const std::string& path);
/// The key of this name, or null.
const Entry* find(const std::vector<Entry>& keys, std::string_view name);
/// The elements of a list; they keep the list's name and path.
std::vector<Entry> elements(const Entry& list);

/// "file:line: "
std::string place(const std::string& file, toml::source_index line);
/// Throw SpecError with "file:line: path = value: why", "file:line: path: why" or "file:line: unknown key path (...)".
[[noreturn]] void refuse_value(const Entry& entry, std::string_view why);
[[noreturn]] void refuse(const Entry& entry, std::string_view why);
[[noreturn]] void refuse_unknown(const Entry& entry, std::span<const std::string_view> known);

/// The value as a type; refuse_value() if it has another one.
const toml::table& as_table(const Entry& entry);
std::string as_string(const Entry& entry);
/// The place in the list `allowed` of a string.
std::size_t as_one_of(const Entry& entry, std::span<const std::string_view> allowed);
bool as_truth(const Entry& entry);
double as_number(const Entry& entry);              ///< an integer or a float
std::int64_t as_whole_number(const Entry& entry);  ///< an integer, to the bit, or a float such as 61.0
std::uint64_t as_count(const Entry& entry, std::uint64_t least, std::uint64_t most);

}  // namespace sigmasweep::spec
