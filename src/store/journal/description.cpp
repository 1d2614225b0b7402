#include "store/journal/description.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

#include "sigmasweep/model/physics_version.hpp"
#include "store/build_info.hpp"

namespace sigmasweep {

std::string description_of(const JournalDescription& description) {
  using json = nlohmann::ordered_json;
  const TableInfo& info = description.info;
  json document = {{"title", info.title},
                   {"start", info.start},
                   {"host", info.host},
                   {"ranks", info.ranks},
                   {"slice", {info.slice.index, info.slice.count}},
                   {"physics_version", physics_version},
                   {"build", build_name()},
                   {"results", json::array()},
                   {"spec_hash", info.spec_hash},
                   {"spec", info.spec_text}};
  for (const Field& field : description.results) document["results"].push_back(field.name);
  return document.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

std::optional<JournalDescription> parse_description(std::string_view text) {
  try {
    const auto document = nlohmann::json::parse(text);
    JournalDescription description;
    TableInfo& info = description.info;
    document.at("title").get_to(info.title);
    document.at("start").get_to(info.start);
    document.at("host").get_to(info.host);
    document.at("ranks").get_to(info.ranks);
    document.at("slice").at(0).get_to(info.slice.index);
    document.at("slice").at(1).get_to(info.slice.count);
    document.at("physics_version").get_to(info.physics_version);
    document.at("build").get_to(info.build);
    document.at("spec_hash").get_to(info.spec_hash);
    document.at("spec").get_to(info.spec_text);
    if (info.slice.index >= info.slice.count) return std::nullopt;
    if (!document.contains("results")) return description;  // format 2
    for (const std::string& name : document.at("results").get<std::vector<std::string>>()) {
      const auto field = std::ranges::find(result_fields(), name, &Field::name);
      if (field == result_fields().end()) return std::nullopt;
      description.results.push_back(*field);
    }
    return description;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

std::optional<std::string> read_description(const File& file, const std::string& path, const JournalHeader& header) {
  struct stat status {};
  if (::fstat(file.fd(), &status) != 0 || static_cast<std::uint64_t>(status.st_size) < first_record(header))
    return std::nullopt;
  std::string text(header.description_size, '\0');
  const std::size_t got = read_at(file.fd(), std::as_writable_bytes(std::span(text)), sizeof header, path);
  text.resize(got);
  if (!is_description_of(header, text)) return std::nullopt;
  return text;
}

}  // namespace sigmasweep
