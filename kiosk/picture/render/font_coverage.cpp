#include "kiosk/picture/render/font_coverage.h"

#include <fontconfig/fontconfig.h>
#include <pango/pango.h>

#include <algorithm>
#include <array>
#include <memory>

#include "kiosk/collection/settings/visitor_text.h"

namespace onggi::render {
namespace {

constexpr std::string_view kBox = "\u25A1";

/// Calls `see(letter, its bytes)` for each letter; for a byte that is no UTF-8 with a space.
template <class See>
void each_letter(std::string_view utf8, See see) {
  while (!utf8.empty()) {
    const gunichar code = g_utf8_get_char_validated(utf8.data(), static_cast<gssize>(utf8.size()));
    const bool good = code < 0x110000;
    const auto bytes = good ? static_cast<std::size_t>(g_unichar_to_utf8(code, nullptr)) : 1;
    see(good ? static_cast<char32_t>(code) : U' ', utf8.substr(0, bytes));
    utf8.remove_prefix(bytes);
  }
}

/// Pango asks no font for these.
bool needs_no_font(char32_t letter) {
  if ((letter >= 0xFE00 && letter <= 0xFE0F) || (letter >= 0xE0100 && letter <= 0xE01EF))
    return true;
  switch (g_unichar_type(letter)) {
    case G_UNICODE_CONTROL:
    case G_UNICODE_FORMAT:
    case G_UNICODE_SURROGATE:
    case G_UNICODE_LINE_SEPARATOR:
    case G_UNICODE_PARAGRAPH_SEPARATOR:
      return true;
    case G_UNICODE_SPACE_SEPARATOR:
      return letter != 0x1680;  // Ogham's has ink
    default:
      return false;
  }
}

struct Destroy {
  void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
  void operator()(FcObjectSet* objects) const { FcObjectSetDestroy(objects); }
  void operator()(FcFontSet* fonts) const { FcFontSetDestroy(fonts); }
};

}  // namespace

const FontCoverage& FontCoverage::here() {
  static const FontCoverage fonts = [] {
    FontCoverage out;
    const std::unique_ptr<FcPattern, Destroy> any(FcPatternCreate());
    const std::unique_ptr<FcObjectSet, Destroy> wanted(
        FcObjectSetBuild(FC_CHARSET, FC_FONTFORMAT, nullptr));
    const std::unique_ptr<FcFontSet, Destroy> found(FcFontList(nullptr, any.get(), wanted.get()));
    for (int n = 0; found && n < found->nfont; ++n) {
      FcChar8* format = nullptr;
      FcCharSet* letters = nullptr;
      // Pango draws no others.
      const bool drawn =
          FcPatternGetString(found->fonts[n], FC_FONTFORMAT, 0, &format) == FcResultMatch &&
          (std::string_view(reinterpret_cast<const char*>(format)) == "TrueType" ||
           std::string_view(reinterpret_cast<const char*>(format)) == "CFF");
      if (!drawn || FcPatternGetCharSet(found->fonts[n], FC_CHARSET, 0, &letters) != FcResultMatch)
        continue;
      std::array<FcChar32, FC_CHARSET_MAP_SIZE> page{};
      FcChar32 next = 0;
      for (FcChar32 base = FcCharSetFirstPage(letters, page.data(), &next); base != FC_CHARSET_DONE;
           base = FcCharSetNextPage(letters, page.data(), &next))
        for (FcChar32 bit = 0; bit < 32 * FC_CHARSET_MAP_SIZE; ++bit)
          if ((page[bit / 32] >> bit % 32 & 1u) != 0 && base + bit < out.letters_.size())
            out.letters_[base + bit] = true;
    }
    return out;
  }();
  return fonts;
}

FontCoverage FontCoverage::of(const std::vector<char32_t>& letters) {
  FontCoverage out;
  for (const char32_t letter : letters) out.letters_[letter] = true;
  return out;
}

bool FontCoverage::draws(char32_t letter) const {
  if (has(letter) || needs_no_font(letter)) return true;
  std::array<gunichar, G_UNICHAR_MAX_DECOMPOSITION_LENGTH> parts{};
  const gsize count = g_unichar_fully_decompose(letter, FALSE, parts.data(), parts.size());
  return count > 1 && std::all_of(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(count),
                                  [this](gunichar part) { return has(part); });
}

FontCoverage::Missing FontCoverage::missing_in(std::string_view utf8) const {
  Missing out;
  bool drawn = false;
  each_letter(utf8, [&](char32_t letter, std::string_view bytes) {
    if (settings::is_blank(bytes)) return;
    if (draws(letter))
      drawn = true;
    else if (std::ranges::find(out.letters, letter) == out.letters.end())
      out.letters.push_back(letter);
  });
  out.all = !out.letters.empty() && !drawn;
  return out;
}

std::string FontCoverage::boxed(std::string_view utf8) const {
  std::string out;
  out.reserve(utf8.size());
  each_letter(utf8, [&](char32_t letter, std::string_view bytes) {
    if (draws(letter))
      out += bytes;
    else if (!settings::is_blank(bytes))
      out += has(U'\u25A1') ? kBox : "?";
  });
  return out;
}

}  // namespace onggi::render
