#include "tests/kiosk/screens/layout_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kiosk/screens/layout.h"

namespace onggi::screens {

using view::Rect;

namespace {

constexpr float kTouching = 1.5f;  // Pixels that may meet: hairlines, rounding.

bool overlap(const Rect& a, const Rect& b) {
  return a.x + a.w - kTouching > b.x && b.x + b.w - kTouching > a.x &&
         a.y + a.h - kTouching > b.y && b.y + b.h - kTouching > a.y;
}

bool inside(const Rect& a, const Rect& b) {
  return a.x >= b.x - kTouching && a.y >= b.y - kTouching && a.x + a.w <= b.x + b.w + kTouching &&
         a.y + a.h <= b.y + b.h + kTouching;
}

std::string print(const Rect& r) {
  return std::to_string(r.x) + "," + std::to_string(r.y) + " " + std::to_string(r.w) + "x" +
         std::to_string(r.h);
}

struct Words {
  Rect rect;
  std::string text;
};

}  // namespace

void check_layout(const Visitor& v, const view::TextMeasure& measure, const std::string& name) {
  const std::string where = name + " " + std::to_string(v.width) + "x" + std::to_string(v.height) +
                            " " + v.visit->language() +
                            (v.exhibit.screen.left_handed ? " left" : "");
  const Rect screen{0, 0, static_cast<float>(v.width), static_cast<float>(v.height)};
  const TypeScale type = type_scale(v.exhibit.screen, v.width, v.height);

  std::vector<Words> words;
  std::vector<Rect> pictures;
  for (const view::Item& item : v.frame.items) {
    if (const auto* picture = std::get_if<view::Picture>(&item)) pictures.push_back(picture->box);
    const auto* text = std::get_if<view::Text>(&item);
    if (text == nullptr) continue;
    const auto size = measure.measure(text->text, text->style, text->box.w);
    EXPECT_LE(size.width, text->box.w + kTouching) << where << ": cut: " << text->text;
    EXPECT_LE(size.height, text->box.h + kTouching) << where << ": cut: " << text->text;
    EXPECT_GE(text->style.px, type.body * 0.7f) << where << ": too small: " << text->text;
    EXPECT_EQ(text->text.find('['), std::string::npos) << where << ": " << text->text;
    EXPECT_EQ(text->text.find('{'), std::string::npos) << where << ": " << text->text;
    Rect ink{text->box.x, text->box.y, size.width, size.height};
    if (text->style.align == view::Align::centre) ink.x += (text->box.w - size.width) / 2;
    EXPECT_TRUE(inside(ink, screen))
        << where << ": off the screen: " << text->text << " " << print(ink);
    words.push_back({ink, text->text});
  }
  for (std::size_t i = 0; i < words.size(); ++i) {
    for (std::size_t k = i + 1; k < words.size(); ++k)
      EXPECT_FALSE(overlap(words[i].rect, words[k].rect))
          << where << ": \"" << words[i].text << "\" " << print(words[i].rect) << " overlaps \""
          << words[k].text << "\" " << print(words[k].rect);
    for (const Rect& picture : pictures)
      EXPECT_FALSE(overlap(words[i].rect, picture))
          << where << ": a picture lies over \"" << words[i].text << "\"";
  }
  const auto controls = v.visit->controls();
  for (std::size_t i = 0; i < controls.size(); ++i) {
    const Rect& a = controls[i].second;
    EXPECT_GE(std::min(a.w, a.h), type.target - 0.5f) << where << ": " << controls[i].first;
    EXPECT_TRUE(inside(a, screen)) << where << ": " << controls[i].first << " " << print(a);
    for (std::size_t k = i + 1; k < controls.size(); ++k)
      EXPECT_FALSE(overlap(a, controls[k].second))
          << where << ": " << controls[i].first << " " << print(a) << " overlaps "
          << controls[k].first << " " << print(controls[k].second);
    for (const Words& w : words)
      EXPECT_TRUE(!overlap(a, w.rect) || inside(w.rect, a))
          << where << ": " << controls[i].first << " cuts \"" << w.text << "\"";
  }
}

}  // namespace onggi::screens
