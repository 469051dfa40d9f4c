#include "kiosk/exhibit/composition/check_letters.h"

#include <cstdio>
#include <string>

#include "engine/base/plain_text.h"
#include "kiosk/ground/toml/texts_of.h"

namespace onggi::exhibit {
namespace {

constexpr std::size_t kNamed = 3;

/// "U+11F02", and the letter itself: a curator's editor may have a font for it.
std::string named(char32_t letter) {
  char code[16];
  std::snprintf(code, sizeof code, "U+%04X", static_cast<unsigned>(letter));
  std::string utf8;
  if (letter < 0x80) {
    utf8 += static_cast<char>(letter);
  } else {
    const int more = letter < 0x800 ? 1 : letter < 0x10000 ? 2 : 3;
    utf8 += static_cast<char>((0xF0u << (3 - more) & 0xFFu) | letter >> 6 * more);
    for (int k = more - 1; k >= 0; --k)
      utf8 += static_cast<char>(0x80u | (letter >> 6 * k & 0x3Fu));
  }
  return std::string(code) + " (" + terminal::plain(utf8) + ")";
}

std::string listed(const std::vector<char32_t>& letters) {
  std::string out;
  for (std::size_t n = 0; n < letters.size() && n < kNamed; ++n)
    out += (n == 0 ? "" : ", ") + named(letters[n]);
  if (letters.size() > kNamed) out += " and " + std::to_string(letters.size() - kNamed) + " more";
  return out;
}

}  // namespace

LettersReport check_letters(const std::vector<std::filesystem::path>& files,
                            const render::FontCoverage& fonts) {
  LettersReport out;
  for (const std::filesystem::path& file : files) {
    if (file.extension() != ".toml") continue;
    for (const toml::TextAt& text : toml::texts_of(file)) {
      const auto missing = fonts.missing_in(text.text);
      if (missing.letters.empty()) continue;
      (missing.all ? out.problems : out.notes)
          .push_back({text.where,
                      "No font on this machine has " + listed(missing.letters) + ". " +
                          (missing.all ? "Visitors would see nothing but boxes here."
                                       : "Visitors see a box in its place."),
                      "Install a package with fonts, such as fonts-noto-core, or write the text "
                      "with other letters."});
    }
  }
  return out;
}

}  // namespace onggi::exhibit
