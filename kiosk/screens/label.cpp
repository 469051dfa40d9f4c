#include "kiosk/screens/label.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace onggi::screens {

std::string label_line(const content::Label& label) {
  if (label.culture.empty() || label.date.empty()) return label.culture + label.date;
  return label.culture + ", " + label.date;
}

std::string centimetres(double metres) {
  const double tenths = std::round(metres * 1000.0);
  char text[32];
  std::snprintf(text, sizeof text, std::fmod(tenths, 10.0) == 0.0 ? "%.0f" : "%.1f", tenths / 10.0);
  return text;
}

std::vector<std::string> sentences(const std::string& text) {
  std::vector<std::string> found;
  std::size_t begin = 0;
  const auto take = [&](std::size_t end) {
    while (begin < end && text[begin] == ' ') ++begin;
    if (end > begin) found.push_back(text.substr(begin, end - begin));
    begin = end;
  };
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    const char c = text[i];
    if ((c == '.' || c == '?' || c == '!') && text[i + 1] == ' ') take(i + 1);
    // Chinese and Japanese full stop, U+3002, three bytes and no space after it.
    if (text.compare(i, 3, "\xE3\x80\x82") == 0) take(i + 3);
  }
  take(text.size());
  return found;
}

float paragraph_gap(const view::TextStyle& style) { return style.px * 0.5f; }

std::vector<LabelPart> parts_that_fit(Page& page, const std::vector<std::string>& paragraphs,
                                      const view::TextStyle& style, const view::Rect& box) {
  const float width = std::min(box.w, style.px * 0.52f * 55.0f);
  const auto height = [&](const std::string& words) {
    return page.size(words, style, width).height;
  };
  std::vector<LabelPart> parts(1);
  float used = 0;  // By the whole paragraphs of the last part.
  for (const std::string& paragraph : paragraphs) {
    std::string words;
    for (const std::string& sentence : sentences(paragraph)) {
      const float before = parts.back().empty() ? 0.0f : used + paragraph_gap(style);
      const std::string longer = words.empty() ? sentence : words + " " + sentence;
      if (before + height(longer) <= box.h) {
        words = longer;
        continue;
      }
      if (!words.empty()) parts.back().push_back(std::move(words));
      if (!parts.back().empty()) parts.emplace_back();
      used = 0;
      words = sentence;
      if (height(words) > box.h) page.overflowed();
    }
    if (words.empty()) continue;
    used += (parts.back().empty() ? 0.0f : paragraph_gap(style)) + height(words);
    parts.back().push_back(std::move(words));
  }
  return parts;
}

}  // namespace onggi::screens
