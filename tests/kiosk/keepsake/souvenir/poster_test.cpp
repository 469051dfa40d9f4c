#include "kiosk/keepsake/souvenir/poster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "kiosk/collection/settings/visitor_text.h"
#include "tests/kiosk/keepsake/souvenir/wide_measure.h"

namespace onggi::souvenir::poster_test {
namespace {

/// Texts as long as an exhibit may have them.
PosterWords longest() {
  const auto of = [](std::size_t letters) {
    std::string text;
    for (std::size_t n = 0; n < letters; ++n) text += n % 8 == 7 ? ' ' : 'w';
    return text;
  };
  PosterWords words;
  words.title = of(settings::bounds::kExhibitTitle.letters);
  words.lead = of(260);
  words.vessel = of(settings::bounds::kTitle.letters + settings::bounds::kCulture.letters);
  words.credit = of(settings::bounds::kLabelCredit.letters);
  words.museum = of(settings::bounds::kExhibitCredit.letters);
  words.address = "https://museum.org/pottery";
  words.address_words = "museum.org/pottery";
  return words;
}

/// Every box of the frame; the code's modules as one.
std::vector<view::Rect> places_of(const view::Frame& poster) {
  std::vector<view::Rect> places;
  view::Rect code{};
  for (const view::Item& item : poster.items) {
    if (const auto* text = std::get_if<view::Text>(&item)) places.push_back(text->box);
    if (const auto* picture = std::get_if<view::Picture>(&item)) places.push_back(picture->box);
    if (const auto* box = std::get_if<view::Box>(&item)) {
      if (code.w == 0) code = box->rect;
      const float right = std::max(code.x + code.w, box->rect.x + box->rect.w);
      const float foot = std::max(code.y + code.h, box->rect.y + box->rect.h);
      code.x = std::min(code.x, box->rect.x);
      code.y = std::min(code.y, box->rect.y);
      code.w = right - code.x;
      code.h = foot - code.y;
    }
  }
  if (code.w > 0) places.push_back(code);
  return places;
}

TEST(Poster, TheLongestTextsOverlapNothingAndStayOnThePaper) {
  for (const bool right_to_left : {false, true}) {
    PosterWords words = longest();
    words.right_to_left = right_to_left;
    const std::vector<view::Rect> places = places_of(compose_poster(words, 7, WideMeasure()));
    ASSERT_EQ(places.size(), 6u);
    for (std::size_t a = 0; a < places.size(); ++a) {
      const view::Rect& one = places[a];
      EXPECT_TRUE(one.x >= 0 && one.y >= 0 && one.x + one.w <= kPosterWidth &&
                  one.y + one.h <= kPosterHeight)
          << a;
      for (std::size_t b = a + 1; b < places.size(); ++b) {
        const view::Rect& other = places[b];
        EXPECT_TRUE(one.x + one.w <= other.x || other.x + other.w <= one.x ||
                    one.y + one.h <= other.y || other.y + other.h <= one.y)
            << a << " " << b;
      }
    }
  }
}

TEST(Poster, WithoutAnAddressItHasNoCodeAndItsWordsTheWholeWidth) {
  PosterWords words = longest();
  words.address.clear();
  words.address_words.clear();
  const std::vector<view::Rect> places = places_of(compose_poster(words, 7, WideMeasure()));
  EXPECT_EQ(places.size(), 4u);
  EXPECT_EQ(places.back().w, places[1].w);
}

}  // namespace
}  // namespace onggi::souvenir::poster_test
