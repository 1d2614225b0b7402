#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

/// The TOML side of a spec: keys with their values and places, and the one message that a bad one leads to.
namespace sigmasweep::spec {

/// A key of the spec with its value. Refers to the parsed document and to the file's name, which outlive it.
struct Entry {
  const std::string* file = nullptr;
  std::string path;                  ///< such as sweep.s0.from
  std::string_view name;             ///< its last part
  const toml::node* node = nullptr;  ///< its value
  toml::source_index line = 0;       ///< 0 if unknown
};

/// The keys of a table in the order of the file.
std::vector<Entry> entries(const toml::table& table, const std::string& file, const std::string& path);
/// The elements of a list; they keep the list's name and path.
std::vector<Entry> elements(const Entry& list);

/// "file:line: "
std::string place(const std::string& file, toml::source_index line);
/// Throw SpecError: "file:line: path = value: why", "file:line: path: why", "file:line: unknown key path (...)".
[[noreturn]] void refuse_value(const Entry& entry, std::string_view why);
[[noreturn]] void refuse(const Entry& entry, std::string_view why);
[[noreturn]] void refuse_unknown(const Entry& entry, std::span<const std::string_view> known);

/// The value as what it must be; refuse_value() if it is something else.
const toml::table& as_table(const Entry& entry);
std::string as_string(const Entry& entry);
/// One of `allowed`, by its place in that list.
std::size_t as_one_of(const Entry& entry, std::span<const std::string_view> allowed);
bool as_truth(const Entry& entry);
double as_number(const Entry& entry);  ///< an integer or a float
std::uint64_t as_count(const Entry& entry, std::uint64_t least, std::uint64_t most);

}  // namespace sigmasweep::spec
