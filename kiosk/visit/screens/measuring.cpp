#include "kiosk/visit/screens/measuring.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

namespace onggi::screens {
namespace {

// More texts than one layout of a long label or a large shelf needs.
constexpr std::size_t kMostKnown = 16384;
// Twice as many at the most: Pango keeps 256 sets of fonts, one for each writing of each size.
constexpr std::size_t kMostSets = 128;

/// Guesses that a letter is half as wide as high, and a wide one (three bytes) as wide as high.
view::TextMeasure::Size guessed_size(const std::string& words, const view::TextStyle& style,
                                     float width) {
  const float whole = style.px * std::max(1.0f, 0.5f * static_cast<float>(words.size()));
  const float lines = width > 0 ? std::ceil(whole / std::max(width, style.px)) : 1.0f;
  return {width > 0 ? std::min(whole, width) : whole,
          std::round(style.px * style.line_height) * lines};
}

// Kinds of writing, roughly, by a letter's first byte. 0 goes with any: spaces, digits, marks.
int writing_of(unsigned char first) {
  const bool latin = (first | 0x20u) >= 'a' && (first | 0x20u) <= 'z';
  if (first < 0x80) return latin ? 1 : 0;
  if (first < 0xc2 || first == 0xe2) return 0;  // a later byte; punctuation
  if (first < 0xcd) return 1;
  if (first < 0xd4) return 2;  // Greek, Cyrillic
  if (first < 0xd8) return 3;  // Hebrew
  if (first < 0xe0) return 4;  // Arabic
  if (first < 0xe2) return 5;  // Thai and its neighbours
  if (first < 0xee) return 6;  // Chinese, Japanese, Korean
  return first < 0xf0 ? 7 : 8;
}

// How often a text changes its writing. Each change is shaped apart, perhaps with another font.
std::size_t changes_of_writing(const std::string& words) {
  std::size_t changes = 0;
  int last = 0;
  for (const char letter : words) {
    const int now = writing_of(static_cast<unsigned char>(letter));
    if (now == 0) continue;
    if (last != 0 && now != last) ++changes;
    last = now;
  }
  return changes;
}

std::int32_t rounded(float x) { return static_cast<std::int32_t>(std::lround(x)); }

}  // namespace

view::TextMeasure::Size Measuring::operator()(const std::string& words,
                                              const view::TextStyle& style, float width) {
  // Bytes, because printing six figures costs more than the rest of a look-up.
  const std::int32_t cut[] = {static_cast<std::int32_t>(style.face), style.bold ? 1 : 0,
                              rounded(100 * style.px)};
  const std::int32_t setting[] = {style.right_to_left ? 1 : 0, rounded(100 * style.line_height),
                                  rounded(10 * width)};
  std::string key(reinterpret_cast<const char*>(cut), sizeof cut);
  key.append(style.language);
  const std::size_t font = key.size();
  key.append(1, '\n').append(reinterpret_cast<const char*>(setting), sizeof setting).append(words);
  if (const auto found = known_.find(key); found != known_.end()) return found->second;
  // Countdowns and speeds make new words for months, so drop old ones instead of growing.
  if (known_.size() >= kMostKnown) older_ = std::exchange(known_, {});
  if (const auto found = older_.find(key); found != older_.end())
    return known_[std::move(key)] = found->second;
  if (spent()) return guessed_size(words, style, width);
  bytes_ += words.size() + kEach * (1 + changes_of_writing(words)) +
            kWriting * new_writings(key.substr(0, font), words);
  return known_[std::move(key)] = measure_.measure(words, style, width);
}

std::size_t Measuring::new_writings(const std::string& font, const std::string& words) {
  unsigned all = 0;
  for (const char letter : words) all |= 1u << writing_of(static_cast<unsigned char>(letter));
  if (sets_ >= kMostSets) {
    older_writings_ = std::exchange(writings_, {});
    sets_ = 0;
  }
  unsigned& set = writings_[font];
  const unsigned fresh = all & ~1u & ~set;
  set |= fresh;
  sets_ += static_cast<std::size_t>(std::popcount(fresh));
  const auto older = older_writings_.find(font);
  return static_cast<std::size_t>(
      std::popcount(older == older_writings_.end() ? fresh : fresh & ~older->second));
}

}  // namespace onggi::screens
