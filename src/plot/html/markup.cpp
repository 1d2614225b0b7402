#include "plot/html/markup.hpp"

#include <cstddef>

namespace sigmasweep::plot {
namespace {

std::string escaped(char c) {
  switch (c) {
    case '&': return "&amp;";
    case '<': return "&lt;";
    case '>': return "&gt;";
    case '"': return "&quot;";
    case '\'': return "&#39;";
    default: return static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? " " : std::string(1, c);
  }
}

bool is_continued(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// Reads enhanced text from its beginning to its end.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  std::string all() {
    std::string html;
    while (at_ < text_.size()) html += piece();
    return html;
  }

 private:
  /// A character, or what stands in braces, with a tag for what is before it.
  std::string piece() {
    const char c = text_[at_];
    if ((c == '_' || c == '^') && at_ + 1 < text_.size()) {
      ++at_;
      const std::string tag = c == '_' ? "sub" : "sup";
      return "<" + tag + ">" + piece() + "</" + tag + ">";
    }
    if (c == '{') return braces();
    if (c == '\\' && at_ + 1 < text_.size()) ++at_;
    std::string html = escaped(text_[at_++]);
    while (at_ < text_.size() && is_continued(text_[at_])) html += text_[at_++];
    return html;
  }

  /// "{/:Italic x}" or "{...}": fonts are dropped but for italics.
  std::string braces() {
    ++at_;
    bool italic = false;
    if (at_ < text_.size() && text_[at_] == '/') {
      const std::size_t end = std::min(text_.find_first_of(" }", at_), text_.size());
      italic = text_.substr(at_, end - at_).find("Italic") != text_.npos;
      at_ = end < text_.size() && text_[end] == ' ' ? end + 1 : end;
    }
    std::string html;
    while (at_ < text_.size() && text_[at_] != '}') html += piece();
    ++at_;
    return italic ? "<i>" + html + "</i>" : html;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

std::string html_of_markup(std::string_view markup) { return Reader(markup).all(); }

std::string escape_html(std::string_view text) {
  std::string html;
  for (const char c : text) html += escaped(c);
  return html;
}

}  // namespace sigmasweep::plot
