#include "store/journal/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/output/place.hpp"

namespace sigmasweep {
namespace {

namespace fs = std::filesystem;

/// A number > 0 as journal_of_rank() writes it; 0 for anything else.
int number_in(std::string_view digits) {
  int number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool is_whole = error == std::errc{} && end == digits.data() + digits.size();
  return is_whole && digits.front() != '0' ? number : 0;
}

}  // namespace

std::string journal_of_rank(const std::string& table_path, int rank) {
  std::string path = beside(table_path, ".journal");
  if (rank > 0) path += fmt::format(".{}", rank);
  return path;
}

std::vector<int> other_ranks_with_journals(const std::string& table_path) {
  const fs::path first(journal_of_rank(table_path, 0));
  const std::string prefix = first.filename().string() + ".";
  std::vector<int> ranks;
  std::error_code none;
  for (fs::directory_iterator it(first.has_parent_path() ? first.parent_path() : ".", none), end; it != end;
       it.increment(none)) {
    const std::string name = it->path().filename();
    if (!name.starts_with(prefix) || name.size() == prefix.size()) continue;
    if (const int rank = number_in(std::string_view(name).substr(prefix.size())); rank > 0) ranks.push_back(rank);
  }
  std::ranges::sort(ranks);
  return ranks;
}

std::vector<std::string> journals_beside(const std::string& table_path) {
  std::vector<std::string> paths;
  std::error_code none;
  if (std::string first = journal_of_rank(table_path, 0); fs::exists(fs::symlink_status(first, none)))
    paths.push_back(std::move(first));
  for (const int rank : other_ranks_with_journals(table_path)) paths.push_back(journal_of_rank(table_path, rank));
  return paths;
}

}  // namespace sigmasweep
