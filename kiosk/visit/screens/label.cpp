#include "kiosk/visit/screens/label.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace onggi::screens {

namespace {

/// Chinese and Japanese sentence ends: three bytes each, no space after them.
constexpr std::array<const char*, 3> kWideStops{"\u3002", "\uFF01", "\uFF1F"};

bool ends_wide(const std::string& words) {
  return std::any_of(kWideStops.begin(), kWideStops.end(),
                     [&](const char* stop) { return words.ends_with(stop); });
}

}  // namespace

std::string label_line(const content::Label& label, const content::Language& language) {
  if (label.culture.empty() || label.date.empty()) return label.culture + label.date;
  return language.say("all.list", {{"first", label.culture}, {"second", label.date}});
}

std::array<std::string, 2> under_title(const content::Label& label) {
  if (label.what.empty()) return {label.culture, label.date};
  return {label.what, label.culture};
}

std::string centimetres(double metres, const content::Language& language) {
  const auto tenths = static_cast<long>(std::lround(metres * 1000.0));
  std::string text = std::to_string(tenths / 10);
  if (tenths % 10 != 0) text += language.decimal() + std::to_string(tenths % 10);
  return text;
}

std::string hundredths(long number, const content::Language& language) {
  std::string text = std::to_string(number / 100);
  const long rest = number % 100;
  if (rest == 0) return text;
  text += language.decimal() + std::to_string(rest / 10);
  return rest % 10 == 0 ? text : text + std::to_string(rest % 10);
}

std::string joined(const std::string& words, const std::string& sentence) {
  return words.empty() ? sentence : words + (ends_wide(words) ? "" : " ") + sentence;
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
    if (ends_wide(text.substr(i, 3))) take(i + 3);
  }
  take(text.size());
  return found;
}

float paragraph_gap(const view::TextStyle& style) { return style.px * 0.5f; }

std::vector<LabelPart> parts_that_fit(Page& page, const std::vector<std::string>& paragraphs,
                                      const view::TextStyle& style, const view::Rect& box) {
  const float width = std::min(box.w, style.px * 0.52f * 55.0f);
  std::vector<LabelPart> parts(1);
  float used = 0;  // height of the last part's whole paragraphs
  for (const std::string& paragraph : paragraphs) {
    const std::vector<std::string> all = sentences(paragraph);
    std::size_t at = 0;
    const auto words_of = [&](std::size_t count) {
      std::string words;
      for (std::size_t i = at; i < at + count; ++i) words = joined(words, all[i]);
      return words;
    };
    const auto height = [&](std::size_t count) {
      return page.size(words_of(count), style, width).height;
    };
    while (at < all.size()) {
      const float before = parts.back().empty() ? 0.0f : used + paragraph_gap(style);
      const auto fits = [&](std::size_t count) { return before + height(count) <= box.h; };
      // The most sentences that fit. The height grows with each sentence, so search by halves: a
      // paragraph of hundreds is measured only a few times.
      const std::size_t rest = all.size() - at;
      std::size_t most = 0, too_many = 1;
      if (fits(1)) most = fits(rest) ? rest : 1, too_many = most == rest ? rest + 1 : rest;
      while (most + 1 < too_many) {
        const std::size_t middle = most + (too_many - most) / 2;
        (fits(middle) ? most : too_many) = middle;
      }
      const bool alone = most == 0 && parts.back().empty();
      if (alone) {
        page.overflowed();
        most = 1;
      }
      if (most > 0) {
        used = before + height(most);
        parts.back().push_back(words_of(most));
        at += most;
      }
      if (at < all.size()) {
        parts.emplace_back();
        used = 0;
      }
    }
  }
  return parts;
}

}  // namespace onggi::screens
