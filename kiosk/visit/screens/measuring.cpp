#include "kiosk/visit/screens/measuring.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace onggi::screens {
namespace {

// More texts than one layout of a long label or a large shelf needs.
constexpr std::size_t kMostKnown = 16384;

/// Guesses that a letter is half as wide as high, and a wide one (three bytes) as wide as high.
view::TextMeasure::Size guessed_size(const std::string& words, const view::TextStyle& style,
                                     float width) {
  const float whole = style.px * std::max(1.0f, 0.5f * static_cast<float>(words.size()));
  const float lines = width > 0 ? std::ceil(whole / std::max(width, style.px)) : 1.0f;
  return {width > 0 ? std::min(whole, width) : whole,
          std::round(style.px * style.line_height) * lines};
}

std::int32_t rounded(float x) { return static_cast<std::int32_t>(std::lround(x)); }

}  // namespace

view::TextMeasure::Size Measuring::operator()(const std::string& words,
                                              const view::TextStyle& style, float width) {
  // Bytes, because printing six figures costs more than the rest of a look-up.
  const std::int32_t head[] = {static_cast<std::int32_t>(style.face), style.bold ? 1 : 0,
                               style.right_to_left ? 1 : 0,           rounded(100 * style.px),
                               rounded(100 * style.line_height),      rounded(10 * width)};
  std::string key(reinterpret_cast<const char*>(head), sizeof head);
  key.append(style.language).append(1, '\n').append(words);
  if (const auto found = known_.find(key); found != known_.end()) return found->second;
  // Countdowns and speeds make new words for months, so drop old ones instead of growing.
  if (known_.size() >= kMostKnown) older_ = std::exchange(known_, {});
  if (const auto found = older_.find(key); found != older_.end())
    return known_[std::move(key)] = found->second;
  if (spent()) return guessed_size(words, style, width);
  bytes_ += words.size() + kEach;
  return known_[std::move(key)] = measure_.measure(words, style, width);
}

}  // namespace onggi::screens
