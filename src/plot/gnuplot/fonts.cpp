#include "plot/gnuplot/fonts.hpp"

#include <fontconfig/fontconfig.h>

#include <algorithm>
#include <memory>
#include <span>

namespace sigmasweep::plot {
namespace {

template <auto destroy>
struct Destroy {
  template <class T>
  void operator()(T* object) const {
    destroy(object);
  }
};

/// The characters that each installed font has.
class Fonts {
 public:
  Fonts()
      : config_(FcInitLoadConfigAndFonts()),
        any_(FcPatternCreate()),
        characters_(FcObjectSetBuild(FC_CHARSET, nullptr)),
        all_(FcFontList(config_.get(), any_.get(), characters_.get())) {}

  bool have(FcChar32 character) const {
    if (!all_) return true;  // nothing is known
    return std::ranges::any_of(std::span(all_->fonts, static_cast<std::size_t>(all_->nfont)), [&](FcPattern* font) {
      FcCharSet* set = nullptr;
      return FcPatternGetCharSet(font, FC_CHARSET, 0, &set) == FcResultMatch && FcCharSetHasChar(set, character) != 0;
    });
  }

 private:
  std::unique_ptr<FcConfig, Destroy<FcConfigDestroy>> config_;
  std::unique_ptr<FcPattern, Destroy<FcPatternDestroy>> any_;
  std::unique_ptr<FcObjectSet, Destroy<FcObjectSetDestroy>> characters_;
  std::unique_ptr<FcFontSet, Destroy<FcFontSetDestroy>> all_;
};

bool is_ascii(char c) { return (static_cast<unsigned char>(c) & 0x80) == 0; }

}  // namespace

DrawableText with_installed_fonts(std::string_view text) {
  DrawableText drawable;
  if (std::ranges::all_of(text, is_ascii)) return {std::string(text), {}};
  const Fonts fonts;
  while (!text.empty()) {
    FcChar32 character = 0;
    const int length =
        FcUtf8ToUcs4(reinterpret_cast<const FcChar8*>(text.data()), &character, static_cast<int>(text.size()));
    const std::string_view bytes = text.substr(0, length > 0 ? static_cast<std::size_t>(length) : 1);
    const bool known = length > 0 && (is_ascii(bytes.front()) || fonts.have(character));
    drawable.text += known ? bytes : "?";
    if (!known && length > 0 && drawable.missing.find(bytes) == std::string::npos) drawable.missing += bytes;
    text.remove_prefix(bytes.size());
  }
  return drawable;
}

}  // namespace sigmasweep::plot
