#include "kiosk/keepsake/souvenir/postcard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kiosk/picture/view/square_code.h"
#include "tests/kiosk/keepsake/souvenir/wide_measure.h"

namespace onggi::souvenir::postcard_test {
namespace {

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
  w.title = "My pot, inspired by: Panathenaic amphora";
  w.vessel = "Greece, Athens, about 530 BCE";
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

bool apart(const view::Rect& a, const view::Rect& b) {
  return a.x + a.w <= b.x || b.x + b.w <= a.x || a.y + a.h <= b.y || b.y + b.h <= a.y;
}

/// The ink of the codes, one box each from the left; a drawing's strips are lower than a module.
std::vector<view::Rect> codes_of(const view::Frame& card) {
  std::vector<view::Rect> ink, codes;
  for (const view::Box& box : all<view::Box>(card))
    if (box.radius == 0 && box.rect.h >= 3) ink.push_back(box.rect);
  // Of all rows together every column has ink, and between two codes is their quiet.
  std::sort(ink.begin(), ink.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  for (const view::Rect& box : ink) {
    if (codes.empty() || box.x > codes.back().x + codes.back().w + 20) {
      codes.push_back(box);
      continue;
    }
    view::Rect& code = codes.back();
    const float foot = std::max(code.y + code.h, box.y + box.h);
    code.w = std::max(code.w, box.x + box.w - code.x);
    code.y = std::min(code.y, box.y);
    code.h = foot - code.y;
  }
  return codes;
}

view::Rect drawing_of(const view::Frame& card) {
  view::Rect at{1e9f, 1e9f, 0, 0};
  float right = 0, foot = 0;
  for (const auto& line : all<view::Line>(card))
    for (const auto& [x, y] : line.points) {
      at.x = std::min(at.x, x);
      at.y = std::min(at.y, y);
      right = std::max(right, x);
      foot = std::max(foot, y);
    }
  at.w = right - at.x;
  at.h = foot - at.y;
  return at;
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
      "My pot, inspired by: a very long title of a vessel that a curator wrote one late evening, "
      "with where it was found and by whom";
  const auto texts = all<view::Text>(compose_postcard(w, vase(0.05), vase(0.06), WideMeasure()));
  EXPECT_LE(texts.front().box.h, texts.front().style.px * texts.front().style.line_height * 2.1f);
}

TEST(Postcard, NoMarkGoesHome) {
  const auto card = compose_postcard(words(), vase(0.05), vase(0.06), WideMeasure());
  for (const auto& box : all<view::Box>(card)) EXPECT_EQ(box.radius, 0) << "no dots, no stars";
  std::vector<std::string> told;
  for (const auto& text : all<view::Text>(card)) told.push_back(text.text);
  EXPECT_EQ(told, (std::vector<std::string>{words().credit + "\n" + words().date, words().title,
                                            words().vessel}));
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

TEST(Postcard, KeepsWordsCodesAndDrawingApartHoweverMuchIsSaidAndFromEitherSide) {
  PostcardWords most = words();
  most.vessel = "Greece, Athens, about 530 BCE; a long line of words that says whose it was";
  most.credit = std::string(120, 'c');
  most.glaze = "Celadon, 175 mm high";
  most.phone_words = "Your pot on a phone, until 25 November 2026";
  most.address_words = "The vessel at the museum";
  const std::string mine = "http://192.168.4.1:8080/k/" + std::string(26, 'q');
  const std::string longest = "http://" + std::string(93, 'm') + "/k/" + std::string(26, 'q');
  int cards = 0;
  // A bowl is low and wide, a bottle's drawing as high as it may be.
  for (const auto& vessel : {vase(0.02), vase(0.05), vase(0.3)})
    for (const bool right_to_left : {false, true})
      for (const char* title :
           {"My pot, inspired by: Bowl",
            "My pot, inspired by: a very long title of a vessel, with where it was "
            "found, by whom, and on what day of which year"})
        for (const std::string page : {"", "https://museum.org/12.3"})
          for (const std::string& phone : {std::string(), mine, longest}) {
            most.title = title;
            most.right_to_left = right_to_left;
            most.address = page;
            most.phone = phone;
            const auto card = compose_postcard(most, vessel, vase(0.04), WideMeasure());
            SCOPED_TRACE(std::string(title) + ' ' + page + ' ' + phone +
                         (right_to_left ? " from the right" : ""));
            std::vector<view::Rect> parts;
            for (const view::Text& text : all<view::Text>(card)) parts.push_back(text.box);
            const std::size_t texts = parts.size();
            ASSERT_EQ(texts,
                      3u + (phone.empty() ? 0 : 1) + (phone.empty() || page.empty() ? 0 : 1));
            const auto codes = codes_of(card);
            ASSERT_EQ(codes.size(), (page.empty() ? 0u : 1u) + (phone.empty() ? 0u : 1u));
            for (const view::Rect& code : codes) {
              const bool own = !phone.empty() && code.w > 200;
              const view::SquareCode known(own ? phone : page);
              const float quiet = 4 * code.w / static_cast<float>(known.side());
              EXPECT_GE(code.w / static_cast<float>(known.side()), own ? 5.0f : 4.0f) << "a module";
              parts.push_back({code.x - quiet, code.y - quiet, code.w + 2 * quiet,
                               code.h + (phone.empty() ? 1.0f : 2.0f) * quiet});
            }
            parts.push_back(drawing_of(card));
            const view::Rect paper{80, 1390, 1340, 2100 - 120 + 2 - 1390};
            for (const view::Rect& part : parts) {
              EXPECT_GE(part.x, paper.x);
              EXPECT_LE(part.x + part.w, paper.x + paper.w);
              EXPECT_GE(part.y, paper.y);
              EXPECT_LE(part.y + part.h, paper.y + paper.h);
              for (const view::Rect& other : parts)
                EXPECT_TRUE(&part == &other || apart(part, other))
                    << part.x << ',' << part.y << ' ' << part.w << 'x' << part.h << " and "
                    << other.x << ',' << other.y << ' ' << other.w << 'x' << other.h;
            }
            ++cards;
          }
  EXPECT_EQ(cards, 72);
}

TEST(Postcard, ReadFromTheRightChangesSidesAndMirrorsNeitherCodeNorDrawing) {
  PostcardWords w = words();
  w.phone = "http://192.168.4.1:8080/k/" + std::string(26, 'q');
  const auto left = compose_postcard(w, vase(0.05), vase(0.06), WideMeasure());
  w.right_to_left = true;
  const auto right = compose_postcard(w, vase(0.05), vase(0.06), WideMeasure());
  const auto same = [](const view::Rect& a, const view::Rect& b) {
    EXPECT_NEAR(a.x, kPostcardWidth - b.x - b.w, 1.0f);
    EXPECT_NEAR(a.y, b.y, 1.0f);
    EXPECT_NEAR(a.w, b.w, 1.0f);
  };
  same(drawing_of(right), drawing_of(left));
  same(codes_of(right).at(0), codes_of(left).at(0));
  // The wall in section stays on the left of the axis, as vessels are drawn.
  const auto cut = [](const view::Frame& card) {
    float most = 0;
    for (const view::Box& box : all<view::Box>(card))
      if (box.radius == 0 && box.rect.h < 3) most = std::max(most, box.rect.x + box.rect.w);
    const view::Rect at = drawing_of(card);
    return most - (at.x + at.w / 2);
  };
  EXPECT_NEAR(cut(left), cut(right), 1.0f);
  EXPECT_LE(cut(right), 1.0f);
  // And the code's first module is dark at its left.
  const auto modules = [](const view::Frame& card) {
    std::vector<std::pair<int, int>> at;
    const view::Rect code = codes_of(card).at(0);
    for (const view::Box& box : all<view::Box>(card))
      if (box.radius == 0 && box.rect.h >= 3)
        at.emplace_back(static_cast<int>(box.rect.x - code.x),
                        static_cast<int>(box.rect.y - code.y));
    return at;
  };
  EXPECT_EQ(modules(left), modules(right));
}

}  // namespace
}  // namespace onggi::souvenir::postcard_test
