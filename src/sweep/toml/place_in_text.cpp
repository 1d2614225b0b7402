#include "sweep/toml/place_in_text.hpp"

#include <algorithm>

namespace sigmasweep::spec {

std::size_t offset_of(std::string_view text, toml::source_position position) {
  std::size_t at = 0;
  for (toml::source_index line = 1; line < position.line; ++line) at = std::min(text.find('\n', at), text.size()) + 1;
  const auto is_inside = [&](std::size_t i) { return (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U; };
  for (toml::source_index column = 1; column < position.column && at < text.size(); ++column)
    for (++at; at < text.size() && is_inside(at);) ++at;
  return std::min(at, text.size());
}

}  // namespace sigmasweep::spec
