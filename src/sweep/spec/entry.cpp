#include "sweep/spec/entry.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "base/spelling.hpp"
#include "base/text/numbers.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep::spec {
namespace {

constexpr std::size_t longest_shown = 60;

/// A string for a message: on one line, and cut if it is long.
std::string shown(std::string_view text) {
  std::string line;
  for (const char c : text.substr(0, longest_shown))
    line += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  return text.size() > longest_shown ? line + "..." : line;
}

std::string describe(const toml::node& node) {
  if (const auto* value = node.as_string()) return fmt::format("\"{}\"", shown(**value));
  if (const auto* value = node.as_integer()) return fmt::format("{}", **value);
  if (const auto* value = node.as_floating_point()) return fmt::format("{}", **value);
  if (const auto* value = node.as_boolean()) return **value ? "true" : "false";
  if (node.is_array()) return "[...]";
  return node.is_table() ? "{...}" : "a date or time";
}

std::optional<std::int64_t> as_whole(const Entry& entry) {
  if (const auto* value = entry.node->as_integer()) return value->get();
  const auto* value = entry.node->as_floating_point();
  return value != nullptr ? whole_number(value->get()) : std::nullopt;
}

}  // namespace

std::vector<Entry> entries(const toml::table& table, const std::string& file, const std::string& path) {
  struct Placed {
    Entry entry;
    toml::source_position position;
  };
  std::vector<Placed> placed;
  for (auto&& [key, node] : table) {
    const auto position = key.source().begin;
    placed.push_back({{&file, path.empty() ? std::string(key.str()) : fmt::format("{}.{}", path, key.str()), key.str(),
                       &node, position.line},
                      position});
  }
  std::sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) { return a.position < b.position; });
  std::vector<Entry> sorted;
  for (Placed& one : placed) sorted.push_back(std::move(one.entry));
  return sorted;
}

const Entry* find(const std::vector<Entry>& keys, std::string_view name) {
  const auto found = std::ranges::find(keys, name, &Entry::name);
  return found == keys.end() ? nullptr : &*found;
}

std::vector<Entry> elements(const Entry& list) {
  std::vector<Entry> found;
  const auto* array = list.node->as_array();
  if (array == nullptr) refuse_value(list, "must be a list");
  found.reserve(array->size());
  for (const toml::node& node : *array) {
    const auto line = node.source().begin.line;
    found.push_back({list.file, list.path, list.name, &node, line != 0 ? line : list.line});
  }
  return found;
}

std::string place(const std::string& file, toml::source_index line) {
  return line == 0 ? fmt::format("{}: ", file) : fmt::format("{}:{}: ", file, line);
}

void refuse_value(const Entry& entry, std::string_view why) {
  throw SpecError(
      fmt::format("{}{} = {}: {}", place(*entry.file, entry.line), shown(entry.path), describe(*entry.node), why));
}

void refuse(const Entry& entry, std::string_view why) {
  throw SpecError(fmt::format("{}{}: {}", place(*entry.file, entry.line), shown(entry.path), why));
}

void refuse_unknown(const Entry& entry, std::span<const std::string_view> known) {
  throw SpecError(
      fmt::format("{}unknown key {}{}", place(*entry.file, entry.line), shown(entry.path), hint(entry.name, known)));
}

const toml::table& as_table(const Entry& entry) {
  if (const auto* table = entry.node->as_table()) return *table;
  refuse_value(entry, "must be a table");
}

std::string as_string(const Entry& entry) {
  if (const auto* value = entry.node->as_string()) return value->get();
  refuse_value(entry, "must be a string");
}

std::size_t as_one_of(const Entry& entry, std::span<const std::string_view> allowed) {
  const auto* value = entry.node->as_string();
  if (value != nullptr)
    if (const auto place = std::find(allowed.begin(), allowed.end(), value->get()); place != allowed.end())
      return static_cast<std::size_t>(place - allowed.begin());
  const auto near = value != nullptr ? nearest(value->get(), allowed) : std::nullopt;
  refuse_value(entry, fmt::format("must be {}{}", alternatives(allowed),
                                  near && allowed.size() > 1 ? fmt::format(" (did you mean '{}'?)", *near) : ""));
}

bool as_truth(const Entry& entry) {
  if (const auto* value = entry.node->as_boolean()) return value->get();
  refuse_value(entry, "must be true or false");
}

double as_number(const Entry& entry) {
  if (const auto* value = entry.node->as_floating_point()) return value->get();
  if (const auto* value = entry.node->as_integer()) return static_cast<double>(value->get());
  const auto* text = entry.node->as_string();
  refuse_value(entry, fmt::format("must be a number{}", text != nullptr ? number_hint(text->get()) : ""));
}

std::int64_t as_whole_number(const Entry& entry) {
  as_number(entry);
  if (const auto value = as_whole(entry)) return *value;
  refuse_value(entry, "must be a whole number");
}

std::uint64_t as_count(const Entry& entry, std::uint64_t least, std::uint64_t most) {
  const auto value = as_whole(entry);
  if (value && *value >= 0) {
    const auto count = static_cast<std::uint64_t>(*value);
    if (count >= least && count <= most) return count;
  }
  refuse_value(entry, fmt::format("must be a whole number from {} to {}", least, most));
}

}  // namespace sigmasweep::spec
