#include "kiosk/visit/screens/measuring.h"

#include <cstdio>

namespace onggi::screens {

view::TextMeasure::Size Measuring::operator()(const std::string& words,
                                              const view::TextStyle& style, float width) {
  char head[96];
  std::snprintf(head, sizeof head, "%d %d %d %.2f %.2f %.1f ", static_cast<int>(style.face),
                style.bold ? 1 : 0, style.right_to_left ? 1 : 0, static_cast<double>(style.px),
                static_cast<double>(style.line_height), static_cast<double>(width));
  std::string key = head + style.language + '\n' + words;
  if (const auto found = known_.find(key); found != known_.end()) return found->second;
  // Countdowns and speeds make new words for months, so clear the cache instead of growing it.
  if (known_.size() > 2000) known_.clear();
  return known_[std::move(key)] = measure_.measure(words, style, width);
}

}  // namespace onggi::screens
