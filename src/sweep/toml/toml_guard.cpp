#include "sweep/toml/toml_guard.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "sigmasweep/base/errors.hpp"

namespace sigmasweep::spec {
namespace {

constexpr int max_dots = 32;

/// One past the string that begins at `begin`, or the end of the text if the string is not closed. The string is basic
/// or literal, on one line or several.
std::size_t skip_string(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  const bool multi_line = text.substr(begin, 3) == std::string(3, quote);
  for (std::size_t i = begin + (multi_line ? 3 : 1); i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"')
      ++i;
    else if (!multi_line && (text[i] == quote || text[i] == '\n'))
      return i + 1;
    else if (multi_line && text.substr(i, 3) == std::string(3, quote))
      return i + 3;
  }
  return text.size();
}

}  // namespace

void require_parsable(std::string_view text, const std::string& file) {
  if (text.size() > max_text)
    throw SpecError(fmt::format("{}: a spec may have at most {} bytes, this has {}", file, max_text, text.size()));
  int dots = 0;
  std::size_t line = 1;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      const std::size_t end = skip_string(text, i);
      line += static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(i),
                                                  text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
      i = end;
      continue;
    }
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    line += c == '\n';
    if (std::string_view("\n,={}[]").find(c) != std::string_view::npos) dots = 0;
    if (c == '.' && ++dots > max_dots)
      throw SpecError(fmt::format("{}:{}: a key of more than {} dotted parts", file, line, max_dots));
    ++i;
  }
}

}  // namespace sigmasweep::spec
