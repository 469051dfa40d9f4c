#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace onggi::render {

/// The letters that the fonts of this machine have. Pango looks for a letter that no font has
/// through every font, again for each size and style, and a frame would wait for that.
class FontCoverage {
 public:
  /// What fontconfig lists. Asked once, at the first call (10 ms); fonts that are installed later
  /// count after the next start. Any thread.
  static const FontCoverage& here();
  /// Fonts with just these letters, for tests.
  static FontCoverage of(const std::vector<char32_t>& letters);

  /// What a text cannot show.
  struct Missing {
    std::vector<char32_t> letters;  ///< That no font has: each once, as they come.
    bool all = false;               ///< No other letter of the text has ink.
  };
  Missing missing_in(std::string_view utf8) const;
  /// `utf8` with a box (U+25A1) for each letter that no font has, or a question mark if no font has
  /// a box. Such letters without ink are left out.
  std::string boxed(std::string_view utf8) const;

 private:
  bool has(char32_t letter) const { return letters_[letter]; }
  bool draws(char32_t letter) const;

  std::vector<bool> letters_ = std::vector<bool>(0x110000);
};

}  // namespace onggi::render
