#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <tuple>

#include "kiosk/keepsake/souvenir/postcard.h"
#include "kiosk/picture/render/text.h"
#include "kiosk/picture/view/palette.h"
#include "kiosk/picture/view/square_code.h"
#include "tests/kiosk/picture/render/studio_fixture.h"
#include "tests/kiosk/visit/screens/codes_in.h"
#include "tests/kiosk/visit/screens/layout_check.h"

// The museum’s page on a label and on a postcard: a phone must read it off the picture, so zbar
// does. And the shelf under a finger.

namespace onggi::screens::choose_screen_test {
namespace {

const std::string kPage = "https://www.museum.go.kr/site/main/relic/search/view?relicId=305";
const std::string kLongest = "https://museum.org/" + std::string(181, 'x');

/// Somebody reading the first vessel's label, in the exhibit's own fonts.
struct Reader {
  Reader(int width, int height, bool korean, const std::string& address) : v(3, &fonts, true) {
    v.vessels[0].address = address;
    v.width = width;
    v.height = height;
    v.show();
    if (korean) v.speak("ko");
    v.touch("attract.begin");
    v.frames(1);
    v.touch("choose.card.0");
    v.frames(1);
  }
  render::Typesetter fonts;
  Visitor v;
};

constexpr std::pair<int, int> kScreens[] = {{1280, 720}, {1024, 600}, {1920, 1080}, {1080, 1920}};

class AMuseumsPage : public render::testing::StudioTest {};

TEST_F(AMuseumsPage, IsReadOffTheLabelAtEverySizeInBothLanguages) {
  for (const auto& [width, height] : kScreens)
    for (const bool korean : {false, true})
      for (const std::string& page : {kPage, kLongest}) {
        Reader reader(width, height, korean, page);
        check_layout(reader.v, reader.fonts, "label with a page");
        const view::Image image = renderer().draw_offscreen(reader.v.frame);
        const std::string name = "label_" + std::to_string(width) + (korean ? "_ko" : "_en") +
                                 (page == kPage ? "" : "_longest");
        render::testing::keep_for_looking(image, name);
        EXPECT_EQ(codes_in(image), std::vector<std::string>{page}) << name;
      }
}

TEST_F(AMuseumsPage, IsReadOffThePostcard) {
  souvenir::PostcardWords words;
  words.title = "My pot, inspired by: Panathenaic amphora";
  words.vessel = "Greece, Athens, about 530 BCE; a long line of words that says whose it was";
  words.credit =
      "The Museum of Pots, with a credit as long as a museum may have in its exhibit's file";
  words.date = "4 May 2026";
  words.glaze = "Celadon, 175 mm high";
  for (const std::string& page : {kPage, kLongest, std::string()}) {
    words.address = page;
    const view::Frame card = souvenir::compose_postcard(words, jar(0.08), jar(0.09),
                                                        render::Typesetter(), view::Glazing{});
    const view::Image image = renderer().draw_offscreen(card);
    render::testing::keep_for_looking(image, "postcard_" + std::to_string(page.size()));
    EXPECT_EQ(codes_in(image),
              page.empty() ? std::vector<std::string>{} : std::vector<std::string>{page});
  }
}

/// Ink that is no word: the modules of a code.
view::Rect code_in(const view::Frame& frame) {
  float left = 1e9f, top = 1e9f, right = 0, bottom = 0;
  for (const view::Item& item : frame.items)
    if (const auto* box = std::get_if<view::Box>(&item);
        box != nullptr && box->fill == view::kInk && box->radius == 0) {
      left = std::min(left, box->rect.x);
      top = std::min(top, box->rect.y);
      right = std::max(right, box->rect.x + box->rect.w);
      bottom = std::max(bottom, box->rect.y + box->rect.h);
    }
  return {left, top, right - left, bottom - top};
}

TEST(AVesselsLabel, KeepsTheQuietRoundItsCode) {
  for (const auto& [width, height] : kScreens) {
    const Reader reader(width, height, false, kPage);
    const view::Rect code = code_in(reader.v.frame);
    ASSERT_GT(code.w, 0);
    const float quiet = code.w / static_cast<float>(view::SquareCode(kPage).side()) * 4;
    for (const view::Item& item : reader.v.frame.items) {
      const auto* text = std::get_if<view::Text>(&item);
      const auto* picture = std::get_if<view::Picture>(&item);
      if (text == nullptr && picture == nullptr) continue;
      const view::Rect& r = text != nullptr ? text->box : picture->box;
      const bool apart = r.x + r.w <= code.x - quiet || r.x >= code.x + code.w + quiet ||
                         r.y + r.h <= code.y - quiet || r.y >= code.y + code.h + quiet;
      EXPECT_TRUE(apart) << width << ": " << (text != nullptr ? text->text : "the picture");
    }
  }
}

TEST(AVesselsLabel, SaysTheMuseumsPageInWordsAndNothingWhereThereIsNone) {
  const auto words_of = [](const view::Frame& frame) {
    std::string all;
    for (const view::Item& item : frame.items)
      if (const auto* text = std::get_if<view::Text>(&item)) all += text->text + "\n";
    return all;
  };
  const Reader with(1280, 720, false, "https://www.museum.org/12.3"), without(1280, 720, false, "");
  EXPECT_NE(words_of(with.v.frame).find("\nmuseum.org/12.3\n"), std::string::npos);
  EXPECT_NE(words_of(with.v.frame).find("The museum’s page"), std::string::npos);
  EXPECT_EQ(words_of(without.v.frame).find("The museum’s page"), std::string::npos);
  EXPECT_LT(code_in(without.v.frame).w, 0);
}

std::string title_of(const Visitor& v) {
  for (const view::Item& item : v.frame.items)
    if (const auto* text = std::get_if<view::Text>(&item);
        text != nullptr && text->style.face == view::Face::serif)
      return text->text;
  return "";
}

TEST(AVesselsLabel, LeadsToTheVesselMostLikeItAndToNoneWhereNothingIs) {
  Visitor v(4);
  v.shelf[1].target = jar(0.05, 0.20, 0.02);  // a wide dish
  v.shelf[2].target = jar(0.085);
  v.shelf[3].target = jar(0.03, 0.02, 0.09);  // a spire on a broad foot
  for (int i = 0; i < 4; ++i)
    v.vessels[static_cast<std::size_t>(i)].labels["en"].title = "Vessel " + std::to_string(i);
  v.touch("attract.begin");
  v.frames(1);
  v.touch("choose.card.0");
  v.frames(1);
  EXPECT_EQ(title_of(v), "Vessel 0");
  v.touch("choose.alike");
  v.frames(1);
  EXPECT_EQ(title_of(v), "Vessel 2");
  v.touch("choose.alike");
  v.frames(1);
  EXPECT_EQ(title_of(v), "Vessel 0");  // likeness is the same both ways
  v.touch("back");
  v.frames(1);
  EXPECT_EQ(v.visit->focus().empty() || v.visit->focus() == "choose.card.0", true);
  v.touch("choose.card.1");
  v.frames(1);
  EXPECT_EQ(title_of(v), "Vessel 1");
  EXPECT_FALSE(v.visit->control("choose.alike"));
}

/// Somebody before a shelf of many vessels.
struct AtTheShelf : Visitor {
  AtTheShelf(int w, int h, const std::string& name = "") : Visitor(30) {
    for (content::Vessel& vessel : vessels)
      if (!name.empty()) vessel.labels["en"].title = name;
    width = w;
    height = h;
    show();
    touch("attract.begin");
    frames(1);
  }
  /// Of the cards that can be touched: the first and the last.
  std::pair<int, int> seen() const {
    int first = 1000, last = -1;
    for (int i = 0; i < 30; ++i)
      if (visit->control("choose.card." + std::to_string(i)))
        first = std::min(first, i), last = std::max(last, i);
    return {first, last};
  }
  view::Rect first_card() const {
    return *visit->control("choose.card." + std::to_string(seen().first));
  }
  /// A finger goes along the shelf by `by` pixels in a fifth of a second.
  void swipe(float by) {
    const view::Rect card = first_card();
    const float x = by < 0 ? static_cast<float>(width) * 0.8f : static_cast<float>(width) * 0.2f;
    const float y = card.y + card.h / 2;
    down(x, y);
    for (int i = 1; i <= 6; ++i) {
      show();
      move(x + by * static_cast<float>(i) / 6, y);
    }
    up(x + by, y);
  }
};

TEST(TheShelf, GoesAlongWithAFingerAndRestsWithinItsEndsAndOpensNothing) {
  for (const auto& [w, h] : {std::pair{1080, 1920}, {1280, 720}}) {
    AtTheShelf v(w, h);
    EXPECT_EQ(v.seen().first, 0);
    const view::Rect rest = v.first_card();
    v.swipe(-0.5f * static_cast<float>(w));
    v.frames(2);
    EXPECT_GT(v.seen().first, 0) << w;
    EXPECT_TRUE(v.visit->control("choose.previous"));
    EXPECT_NEAR(v.first_card().x, rest.x, 1) << "a whole column stands in front";
    for (int i = 0; i < 30; ++i) v.swipe(-0.5f * static_cast<float>(w));
    v.frames(2);
    EXPECT_EQ(v.seen().second, 29) << w;
    EXPECT_FALSE(v.visit->control("choose.next"));
    for (int i = 0; i < 40; ++i) v.swipe(0.5f * static_cast<float>(w));
    v.frames(2);
    EXPECT_EQ(v.seen().first, 0);
    EXPECT_FALSE(v.visit->control("choose.throw"));
  }
}

TEST(TheShelf, AQuickSwipeRunsOnAfterTheFingerAndATouchStopsItAndOpensNothing) {
  AtTheShelf v(1280, 720);
  v.swipe(-500);
  v.show();
  const auto x_of = [&] {
    for (const view::Item& item : v.frame.items)
      if (const auto* picture = std::get_if<view::Picture>(&item)) return picture->box.x;
    return 0.0f;
  };
  const float before = x_of();
  v.show();
  EXPECT_NE(x_of(), before);
  v.down(600, 300);
  v.show();
  const float held = x_of();
  v.frames(0.5);
  EXPECT_EQ(x_of(), held);
  v.up(600, 300);
  v.frames(2);
  EXPECT_FALSE(v.visit->control("choose.throw"));
}

TEST(TheShelf, ATapIsATapThoughTheFingerSlipsAFewMillimetres) {
  AtTheShelf v(1280, 720);
  const view::Rect card = v.first_card();
  const float x = card.x + card.w / 2, y = card.y + card.h / 2;
  v.down(x, y);
  v.show();
  v.move(x + 9, y + 4);  // 3.7 mm
  v.show();
  v.up(x + 9, y + 4);
  v.frames(1);
  EXPECT_TRUE(v.visit->control("choose.throw"));
}

TEST(TheShelf, ACardAndItsLabelSayWhatTheVesselIs) {
  Visitor v(3);
  v.vessels[0].labels["en"].what = "A pharmacy jar";
  v.vessels[1].labels["en"].what.clear();
  v.touch("attract.begin");
  v.frames(1);
  EXPECT_NE(words_in(v.frame).find("\nA pharmacy jar\n"), std::string::npos) << words_in(v.frame);
  for (const Control& card : v.visit->reading().controls)
    if (card.id == "choose.card.0") {
      EXPECT_NE(card.words.find("A pharmacy jar"), std::string::npos) << card.words;
    }
  v.touch("choose.card.0");
  v.frames(1);
  EXPECT_NE(words_in(v.frame).find("\nA pharmacy jar\n"), std::string::npos) << words_in(v.frame);
}

TEST(TheShelf, ATouchBetweenTwoVesselsTakesTheNearer) {
  // A long shelf, one that is on the screen as a whole, and one of several rows.
  for (const auto& [w, h, all] : {std::tuple{1280, 720, 30}, {1920, 1080, 3}, {1080, 1920, 30}})
    for (const int nearer : {0, 1}) {
      Visitor v(all);
      v.width = w;
      v.height = h;
      v.show();
      v.touch("attract.begin");
      v.frames(1);
      for (std::size_t i = 0; i < v.vessels.size(); ++i)
        v.vessels[i].labels["en"].title = "Vessel " + std::to_string(i);
      v.frames(1);
      const view::Rect a = *v.visit->control("choose.card.0"),
                       b = *v.visit->control("choose.card.1");
      const bool below = b.y > a.y + a.h;
      const float near = nearer == 0 ? 0.3f : 0.7f;
      const float x = below ? a.x + a.w / 2 : a.x + a.w + near * (b.x - a.x - a.w);
      const float y = below ? a.y + a.h + near * (b.y - a.y - a.h) : a.y + a.h / 2;
      ASSERT_FALSE(a.contains(x, y) || b.contains(x, y)) << "a gap";
      v.down(x, y);
      v.show();
      v.up(x, y);
      v.frames(1);
      ASSERT_TRUE(v.visit->control("choose.throw")) << w << "x" << h;
      EXPECT_EQ(title_of(v), "Vessel " + std::to_string(nearer)) << w << "x" << h;
    }
}

TEST(TheShelf, SaysHowMuchMoreThereIsInWordsAndByALine) {
  AtTheShelf v(1280, 720);
  const auto [first, last] = v.seen();
  EXPECT_NE(words_in(v.frame).find("1–" + std::to_string(last + 1) + " of 30"), std::string::npos)
      << words_in(v.frame);
  // The heavy part of the line, from end to end of the shelf.
  const auto line = [&] {
    for (const view::Item& item : v.frame.items)
      if (const auto* box = std::get_if<view::Box>(&item);
          box && box->fill == view::kFaintInk && box->rect.h < 5)
        return box->rect;
    return view::Rect{};
  };
  const view::Rect begun = line();
  ASSERT_GT(begun.w, 0);
  EXPECT_LT(begun.w, 0.5f * static_cast<float>(v.width));
  for (int i = 0; i < 40 && v.visit->control("choose.next"); ++i) {
    v.touch("choose.next");
    v.frames(1.5);
  }
  EXPECT_NE(words_in(v.frame).find("–30 of 30"), std::string::npos);
  EXPECT_GT(line().x, begun.x + begun.w);
}

TEST(TheShelf, TheNextColumnPeeksInAndATouchOnItBringsIt) {
  AtTheShelf v(1080, 1920);
  const int before = v.seen().first;
  const view::Rect card = v.first_card();
  v.down(1070, card.y + card.h / 2);
  v.show();
  v.up(1070, card.y + card.h / 2);
  v.frames(2);
  EXPECT_GT(v.seen().first, before);
  EXPECT_FALSE(v.visit->control("choose.throw"));
}

TEST(TheShelf, ALongWordInANameTakesAWiderColumnAndNoSmallerWords) {
  for (const auto& [width, height] : kScreens) {
    std::set<float> sizes, widths;
    for (int letters = 4; letters <= 24; letters += 2) {
      AtTheShelf v(width, height, std::string(static_cast<std::size_t>(letters), 'm'));
      check_layout(v, v.plain, std::to_string(letters) + " letters");
      for (const view::Item& item : v.frame.items)
        if (const auto* text = std::get_if<view::Text>(&item); text && text->text[0] == 'm')
          sizes.insert(text->style.px);
      widths.insert(v.first_card().w);
    }
    EXPECT_EQ(sizes.size(), 1u) << width << "x" << height;
    EXPECT_GT(widths.size(), 1u) << "a word of 24 letters asks for no more than one of four";
  }
}

TEST(TheShelf, AMouseWheelTurnsItByAColumnANotch) {
  AtTheShelf v(1280, 720);
  const auto notch = [&](float by) {
    view::InputEvent e;
    e.kind = view::InputEvent::Kind::scroll;
    e.scroll = by;
    v.visit->input(e, v.now);
    v.frames(2);
  };
  notch(-1);
  EXPECT_GT(v.seen().first, 0);
  notch(1);
  EXPECT_EQ(v.seen().first, 0);
  notch(1);
  EXPECT_EQ(v.seen().first, 0);
}

TEST(TheShelf, OneArrowReachesTheLastVesselOfARow) {
  AtTheShelf v(1280, 720);
  std::set<std::string> met;
  for (int i = 0; i < 60; ++i) {
    v.key(view::Key::right);
    if (!v.visit->focus().starts_with("choose.card.")) break;
    met.insert(v.visit->focus());
    EXPECT_TRUE(v.visit->control(v.visit->focus()));
  }
  EXPECT_TRUE(met.count("choose.card.28") + met.count("choose.card.29") > 0);
}

TEST(TheShelf, WhoComesBackFromALabelFindsTheShelfWhereItWas) {
  AtTheShelf v(1280, 720);
  v.touch("choose.next");
  v.frames(2);
  const int first = v.seen().first;
  v.touch("choose.card." + std::to_string(v.seen().second));
  v.frames(1);
  v.touch("back");
  v.frames(1);
  EXPECT_EQ(v.seen().first, first);
}

// It went down on attract; where it lifts, the next column peeks in by now.
TEST(TheShelf, IsNotTurnedByTheLiftOfTheTouchThatBegan) {
  Visitor v(20);
  const float x = static_cast<float>(v.width) - 4, y = 0.5f * static_cast<float>(v.height);
  v.down(x, y);
  v.show();
  ASSERT_EQ(v.visit->screen(), ScreenId::choose);
  v.up(x, y);
  v.frames(2);
  EXPECT_TRUE(v.visit->control("choose.card.0"));
  v.down(x, y);
  v.up(x, y);
  v.frames(2);
  EXPECT_FALSE(v.visit->control("choose.card.0")) << "a touch on what peeks in turns it";
}

TEST(ChooseScreen, TheStepOnwardHasOnePlaceOnEveryLabelHoweverMuchItSays) {
  for (const auto& [w, h] : {std::pair{1920, 1080}, {1080, 1920}, {1366, 768}}) {
    Visitor v(4);
    v.width = w;
    v.height = h;
    v.show();
    const std::string word = "Fired upside down in ashes. ";
    for (std::size_t n = 0; n < 4; ++n)
      for (std::size_t m = 0; m < n * n * 12; ++m) v.vessels[n].labels["en"].text += word;
    v.vessels[1].labels["en"].title = "A jar with a very long name that no other jar has";
    std::set<std::pair<float, float>> places;
    for (std::size_t n = 0; n < 4; ++n) {
      v.touch("attract.begin");
      v.frames(1);
      v.touch("choose.card." + std::to_string(n));
      v.frames(1);
      const auto at = v.visit->control("choose.throw");
      ASSERT_TRUE(at);
      places.insert({at->x, at->y});
      while (v.visit->screen() != ScreenId::attract) v.touch("back");
      v.frames(1);
    }
    EXPECT_EQ(places.size(), 1u) << w << "x" << h;
  }
}

TEST(ChooseScreen, AVesselThatWasBuiltOffersThatFirstAndToThrowItSecond) {
  Visitor v(2);
  v.shelf[1].built = v.shelf[1].wheel;
  v.shelf[1].built->coil = 0.013;
  v.shelf[1].built->tools = {{0, "coil", 0.0065, 0.0065}};
  v.shelf[1].scale = 0.325;
  for (const bool built : {true, false}) {
    v.touch("attract.begin");
    v.frames(1);
    v.touch("choose.card.0");
    v.frames(1);
    EXPECT_FALSE(v.visit->control("choose.build")) << "this one is thrown";
    v.touch("back");
    v.frames(1);
    v.touch("choose.card.1");
    v.frames(1);
    std::string words = words_in(v.frame);
    for (int part = 0; part < 4 && v.visit->control("choose.more"); ++part) {
      v.touch("choose.more");
      v.frames(1);
      words += words_in(v.frame);
    }
    for (const char* said :
         {"Build it from coils", "Throw it on the wheel",
          "Its coils are 13 mm thick here. At its real size they would be 4 cm."})
      EXPECT_NE(words.find(said), std::string::npos) << said;
    v.requests();
    v.touch(built ? "choose.build" : "choose.throw");
    v.frames(1);
    const auto asked = v.requests();
    ASSERT_FALSE(asked.empty());
    const auto* start = std::get_if<StartPot>(&asked.front());
    ASSERT_NE(start, nullptr);
    EXPECT_EQ(start->built, built);
    EXPECT_EQ(v.visit->screen(), ScreenId::throwing);
    while (v.visit->screen() != ScreenId::attract) v.touch("back");
    v.frames(1);
  }
}

}  // namespace
}  // namespace onggi::screens::choose_screen_test
