#include "sweep/toml/mistakes.hpp"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sigmasweep::spec {

std::string without_places(const std::string& messages, std::string_view file) {
  std::istringstream lines(messages);
  std::string all;
  for (std::string line; std::getline(lines, line);) {
    if (const auto place = line.find(": "); line.starts_with(file) && place != std::string::npos)
      line.erase(0, place + 2);
    for (const std::string_view prefix : {"sweep.", "sweep: "})
      if (line.starts_with(prefix)) line.erase(0, prefix.size());
    all += all.empty() ? line : "\n" + line;
  }
  return all;
}

void Mistakes::add(const std::string& message) {
  std::istringstream lines(message);
  for (std::string line; std::getline(lines, line);) {
    if (const auto known = line.find("; known: "); known != line.npos && !lists_.insert(line.substr(known)).second)
      line.erase(known);  // a list of keys is shown once
    if (std::ranges::find(lines_, line) == lines_.end()) lines_.push_back(line);
  }
}

void Mistakes::refuse_any(std::size_t most) const {
  if (lines_.empty()) return;
  std::vector<std::string> shown(lines_.begin(), lines_.begin() + std::min(most, lines_.size()));
  if (lines_.size() > most) shown.push_back(fmt::format("and {} more mistakes", lines_.size() - most));
  throw SpecError(fmt::format("{}", fmt::join(shown, "\n")));
}

}  // namespace sigmasweep::spec
