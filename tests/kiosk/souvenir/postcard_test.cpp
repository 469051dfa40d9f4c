#include "kiosk/souvenir/postcard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace onggi::souvenir {
namespace {

/// Half an em a byte, broken anywhere: crude, and wider than any font.
class WideMeasure final : public view::TextMeasure {
 public:
  Size measure(const std::string& text, const view::TextStyle& style, float width) const override {
    Size size;
    std::size_t begin = 0;
    while (begin <= text.size()) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      const float line = static_cast<float>(end - begin) * style.px * 0.5f;
      const float lines = width > 0 ? std::max(1.0f, std::ceil(line / width)) : 1.0f;
      size.width = std::max(size.width, width > 0 ? std::min(line, width) : line);
      size.height += lines * style.px * style.line_height;
      begin = end + 1;
    }
    return size;
  }
};

Profile vase(double belly) {
  Profile p;
  for (int i = 0; i <= 20; ++i) {
    const double t = i / 20.0;
    const double outer = 0.03 + belly * 4 * t * (1 - t);
    p.points.push_back({0.2 * t, outer, t < 0.06 ? 0.0 : outer - 0.006});
  }
  return p;
}

PostcardWords words() {
  PostcardWords w;
  w.title = "My answer to: Panathenaic amphora";
  w.vessel = "Greece, Athens, about 530 BCE";
  w.stars = 3;
  w.credit = "Onggi, shapes drawn from published dimensions";
  w.date = "4 May 2026";
  return w;
}

template <class T>
std::vector<T> all(const view::Frame& frame) {
  std::vector<T> found;
  for (const view::Item& item : frame.items)
    if (const auto* one = std::get_if<T>(&item)) found.push_back(*one);
  return found;
}

TEST(Postcard, IsAPortraitOfTheFiredPotAloneOnPlaster) {
  const auto card = compose_postcard(words(), vase(0.05), vase(0.06), WideMeasure());
  EXPECT_EQ(card.width, 1500);
  EXPECT_EQ(card.height, 2100);
  ASSERT_TRUE(card.pot);
  EXPECT_EQ(card.pot->finish, view::Finish::fired);
  EXPECT_FALSE(card.pot->wheel);
  EXPECT_FALSE(card.pot->hands[0].present);
}

TEST(Postcard, ShowsTheGlazeThatWasChosenAndDryClayWhereNoneWas) {
  view::Glazing glazing;
  glazing.look.glass = {0.1f, 0.2f, 0.3f};
  auto w = words();
  w.glaze = "Tenmoku, 175 mm high";
  const auto card = compose_postcard(w, vase(0.05), vase(0.06), WideMeasure(), glazing);
  EXPECT_EQ(card.pot->glazing.look.glass, glazing.look.glass);
  bool said = false;
  for (const auto& text : all<view::Text>(card))
    said = said || text.text.find("Tenmoku, 175 mm high") != std::string::npos;
  EXPECT_TRUE(said);
  const auto raw = compose_postcard(words(), vase(0.05), vase(0.06), WideMeasure(), std::nullopt);
  EXPECT_EQ(raw.pot->finish, view::Finish::clay);
}

TEST(Postcard, SaysTitleVesselCreditAndDateWithoutOverlap) {
  const auto w = words();
  const auto texts = all<view::Text>(compose_postcard(w, vase(0.05), vase(0.06), WideMeasure()));
  std::string said;
  for (const auto& text : texts) said += text.text + "\n";
  for (const std::string& each : {w.title, w.vessel, w.credit, w.date})
    EXPECT_NE(said.find(each), std::string::npos) << each;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    EXPECT_GE(texts[i].box.x, 0);
    EXPECT_LE(texts[i].box.x + texts[i].box.w, 1500);
    EXPECT_LE(texts[i].box.y + texts[i].box.h, 2100);
    for (std::size_t k = i + 1; k < texts.size(); ++k) {
      const auto &a = texts[i].box, &b = texts[k].box;
      EXPECT_TRUE(a.y + a.h <= b.y || b.y + b.h <= a.y) << texts[i].text << texts[k].text;
    }
  }
}

TEST(Postcard, ALongTitleIsSetSmallerUntilItIsTwoLines) {
  auto w = words();
  w.title =
      "My answer to: a very long title of a vessel that a curator wrote one late evening, "
      "with where it was found and by whom";
  const auto texts = all<view::Text>(compose_postcard(w, vase(0.05), vase(0.06), WideMeasure()));
  EXPECT_LE(texts.front().box.h, texts.front().style.px * texts.front().style.line_height * 2.1f);
}

TEST(Postcard, StarsAreFiveCirclesAsManyFilledAsEarned) {
  for (int stars = 0; stars <= 5; ++stars) {
    auto w = words();
    w.stars = stars;
    int full = 0, empty = 0;
    for (const auto& box :
         all<view::Box>(compose_postcard(w, vase(0.05), vase(0.06), WideMeasure()))) {
      if (box.radius <= 0 || box.rect.w != 2 * box.radius) continue;
      ++(box.fill.a > 0 ? full : empty);
    }
    EXPECT_EQ(full, stars);
    EXPECT_EQ(empty, 5 - stars);
  }
}

TEST(Postcard, TheSectionIsDrawnInTheCornerAndNowhereElse) {
  const auto card = compose_postcard(words(), vase(0.02), vase(0.12), WideMeasure());
  const auto lines = all<view::Line>(card);
  ASSERT_GE(lines.size(), 6u);
  for (const auto& line : lines)
    for (const auto& [x, y] : line.points) {
      EXPECT_GE(x, 1100);
      EXPECT_LE(x, 1390);
      EXPECT_GE(y, 1650);
      EXPECT_LE(y, 1990);
    }
}

TEST(Postcard, AnUnworkedLumpAndAMissingTargetStillMakeACard) {
  const auto card = compose_postcard(words(), vase(0.0), Profile{}, WideMeasure());
  EXPECT_TRUE(card.pot);
  EXPECT_FALSE(all<view::Text>(card).empty());
}

TEST(Postcard, KeepsWordsStarsCodeAndDrawingApartHoweverMuchIsSaid) {
  PostcardWords most = words();
  most.vessel = "Greece, Athens, about 530 BCE; a long line of words that says whose it was";
  most.credit = std::string(120, 'c');
  most.glaze = "Celadon, 175 mm high";
  for (const char* page : {"", "https://museum.org/12.3"}) {
    most.address = page;
    const auto card = compose_postcard(most, vase(0.05), vase(0.06), WideMeasure());
    std::vector<view::Rect> texts, stars;
    for (const view::Text& text : all<view::Text>(card)) texts.push_back(text.box);
    float code_top = 2100, code_left = 1500;
    for (const view::Box& box : all<view::Box>(card)) {
      if (box.radius > 0) stars.push_back(box.rect);
      // Modules are squares side by side; the drawing's strips are 2.2 high.
      if (box.radius > 0 || box.rect.h < 3) continue;
      code_top = std::min(code_top, box.rect.y);
      code_left = std::min(code_left, box.rect.x);
      EXPECT_LE(box.rect.y + box.rect.h, 2100 - 120 + 1);
    }
    ASSERT_EQ(texts.size(), 3u);
    ASSERT_EQ(stars.size(), 5u);
    EXPECT_EQ(code_top < 2100, page[0] != '\0');
    const auto apart = [](const view::Rect& a, const view::Rect& b) {
      return a.x + a.w <= b.x || b.x + b.w <= a.x || a.y + a.h <= b.y || b.y + b.h <= a.y;
    };
    for (const view::Rect& text : texts) {
      EXPECT_GE(text.y, 1400);
      EXPECT_TRUE(text.y + text.h <= code_top || text.x + text.w <= code_left) << page << text.y;
      for (const view::Rect& star : stars) EXPECT_TRUE(apart(text, star)) << page << text.y;
      for (const view::Rect& other : texts) EXPECT_TRUE(&text == &other || apart(text, other));
    }
  }
}

}  // namespace
}  // namespace onggi::souvenir
