#include "sweep/spec/with_points.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "sigmasweep/base/errors.hpp"
#include "sweep/spec/entry.hpp"
#include "sweep/spec/tuples/points.hpp"
#include "sweep/toml/place_in_text.hpp"
#include "sweep/toml/sweep_tables.hpp"
#include "sweep/toml/toml_guard.hpp"

namespace sigmasweep::spec {
namespace {

std::string contents_of(const std::filesystem::path& path, const std::string& where) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string text(max_text + 1, '\0');
  if (!file || std::filesystem::is_directory(path))
    throw InputNotFound(fmt::format("{}cannot read the points {}: {}", where, path.string(),
                                    errno != 0 ? std::strerror(errno) : "it is a folder"));
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > max_text)
    throw SpecError(fmt::format("{}points {}: at most {} bytes are allowed", where, path.string(), max_text));
  return text;
}

/// A string of TOML on one line.
std::string in_quotes(std::string_view text) {
  std::string line = "\"";
  for (const char c : text) {
    if (c == '\n')
      line += "\\n";
    else if (c == '"' || c == '\\')
      line += {'\\', c};
    else if ((static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == 0x7f)
      line += fmt::format("\\u{:04X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    else
      line += c;
  }
  return line + '"';
}

toml::table parsed(std::string_view text) {
  try {
    require_parsable(text, "");
    return toml::parse(text);
  } catch (const toml::parse_error&) {
    return {};
  } catch (const SpecError&) {
    return {};
  }
}

}  // namespace

std::string with_points(std::string_view text, const std::string& spec_path) {
  std::string changed(text);
  const toml::table spec = parsed(text);
  const auto folder = std::filesystem::path(spec_path).parent_path();
  std::map<std::size_t, std::pair<std::size_t, std::string>, std::greater<>> places;  // the last first
  for (const toml::table* table : sweep_tables(spec)) {
    const toml::node* node = table->get("points");
    const auto* name = node != nullptr ? node->as_string() : nullptr;
    if (name == nullptr || name->get().empty() || name->get().find('\n') != std::string::npos) continue;
    const std::string contents = contents_of(folder / name->get(), place(spec_path, node->source().begin.line));
    const std::size_t begin = offset_of(text, node->source().begin), end = offset_of(text, node->source().end);
    places.emplace(begin, std::pair(end - begin, in_quotes(fmt::format("{}{}\n{}", from_file, name->get(), contents))));
  }
  for (const auto& [begin, length_and_text] : places)
    changed.replace(begin, length_and_text.first, length_and_text.second);
  return changed;
}

}  // namespace sigmasweep::spec
