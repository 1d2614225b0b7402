#include "base/printable.hpp"

namespace sigmasweep {

std::string printable(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    // U+0080 to U+009F are control characters, too, of two bytes.
    const bool long_control = c == 0xC2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xA0;
    if (long_control) ++i;
    out += (c < 0x20 && c != '\n') || c == 0x7F || long_control ? ' ' : text[i];
  }
  return out;
}

}  // namespace sigmasweep
