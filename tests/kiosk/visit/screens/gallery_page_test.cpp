#include "kiosk/visit/screens/gallery_page.h"

#include <gtest/gtest.h>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::gallery_page_test {
namespace {

std::vector<view::PictureId> pictures(const Visitor& v) {
  std::vector<view::PictureId> all;
  for (const view::Item& item : v.frame.items)
    if (const auto* picture = std::get_if<view::Picture>(&item)) all.push_back(picture->id);
  return all;
}

bool shows_gallery(const Visitor& v) {
  return words_in(v.frame).find(v.languages[0].say("gallery.title")) != std::string::npos;
}

void finish_attracts_pot(Visitor& v) {
  v.status.script_done = true;
  v.frames(1);
  v.frames(8);
}

TEST(Gallery, AnEmptyOneIsSpokenOfNowhere) {
  Visitor v;
  v.frames(2);
  EXPECT_FALSE(v.visit->control("attract.gallery"));
  finish_attracts_pot(v);
  EXPECT_FALSE(shows_gallery(v));
  v.make_result();
  v.touch("result.keep");
  v.frames(1);
  EXPECT_FALSE(v.visit->control("keepsake.gallery"));
}

// "I have finished" went up as the way to today's pots came, and a finger opened these.
TEST(Gallery, ItsWayComesToTheKeepsakeAndMovesNoOtherButton) {
  Visitor v(9, nullptr, false, true);
  v.make_result();
  v.touch("result.keep");
  v.frames(1);
  const auto done = v.visit->control("keepsake.done"), again = v.visit->control("keepsake.again");
  ASSERT_TRUE(done && again && !v.visit->control("keepsake.gallery"));
  v.keep_today(3);
  v.frames(1);
  const auto way = v.visit->control("keepsake.gallery");
  ASSERT_TRUE(way);
  EXPECT_EQ(v.visit->control("keepsake.done")->y, done->y);
  EXPECT_EQ(v.visit->control("keepsake.done")->x, done->x);
  EXPECT_EQ(v.visit->control("keepsake.again")->y, again->y);
  EXPECT_LT(way->y + way->h, done->y);
}

TEST(Gallery, AfterAPotOfAttractTodaysAreShownForAWhileAndAnyTouchBegins) {
  Visitor v(9, nullptr, false, true);
  v.keep_today(3);
  v.frames(2);
  EXPECT_FALSE(shows_gallery(v));
  finish_attracts_pot(v);
  ASSERT_TRUE(shows_gallery(v));
  EXPECT_EQ(pictures(v), (std::vector<view::PictureId>{1000, 1001, 1002}));
  EXPECT_FALSE(v.frame.pot);
  v.frames(10.5);
  EXPECT_FALSE(shows_gallery(v));
  v.status.script_done = false;
  v.frames(1);
  finish_attracts_pot(v);
  ASSERT_TRUE(shows_gallery(v));
  v.down(640, 300);
  EXPECT_EQ(v.visit->screen(), ScreenId::choose);
}

TEST(Gallery, WhoAsksForItMayMoveItAndHasNotBegun) {
  Visitor v;
  v.keep_today(40);
  v.show();
  v.touch("attract.gallery");
  v.frames(1);
  ASSERT_TRUE(shows_gallery(v));
  EXPECT_EQ(v.visit->screen(), ScreenId::attract);
  const auto before = pictures(v);
  v.down(1100, 300);
  for (int i = 1; i <= 10; ++i) v.move(1100 - 60.0f * static_cast<float>(i), 300), v.show();
  v.up(500, 300);
  v.frames(2);
  EXPECT_EQ(v.visit->screen(), ScreenId::attract);
  EXPECT_GT(pictures(v).front(), before.front()) << "older ones come";
  EXPECT_NE(words_in(v.frame).find("of 40"), std::string::npos);
  v.touch("gallery.next");
  v.frames(2);
  EXPECT_GT(pictures(v).front(), before.front() + 2);
  v.touch("back");
  v.frames(1);
  EXPECT_FALSE(shows_gallery(v));
  v.touch("attract.gallery");
  v.frames(1);
  EXPECT_EQ(pictures(v), before) << "it begins with the newest again";
  v.touch("attract.begin");
  EXPECT_EQ(v.visit->screen(), ScreenId::choose);
}

TEST(Gallery, WhoWalksAwayFromItLeavesAttract) {
  Visitor v;
  v.keep_today(4);
  v.show();
  v.touch("attract.gallery");
  v.frames(40);
  v.down(600, 300), v.up(600, 300);
  v.frames(40);
  EXPECT_TRUE(shows_gallery(v)) << "a touch is somebody who looks";
  v.frames(21);
  EXPECT_FALSE(shows_gallery(v));
  EXPECT_EQ(v.visit->screen(), ScreenId::attract);
}

TEST(Gallery, APotThatIsDeletedIsGoneFromThePageAndTheLastTakesThePageWithIt) {
  Visitor v;
  v.keep_today(2);
  v.show();
  v.touch("attract.gallery");
  v.frames(1);
  v.todays.erase(v.todays.begin());
  v.show();
  EXPECT_EQ(pictures(v), std::vector<view::PictureId>{1001});
  v.todays.clear();
  v.frames(1);
  EXPECT_FALSE(shows_gallery(v));
}

TEST(Gallery, AfterTheKeepsakeItIsATouchAwayAndBackLeadsToThePostcard) {
  Visitor v;
  v.keep_today(5);
  v.make_result();
  v.touch("result.keep");
  v.visit->show_postcard(9);
  v.touch("keepsake.gallery");
  v.frames(1);
  ASSERT_TRUE(shows_gallery(v));
  EXPECT_EQ(pictures(v).size(), 5u);
  v.touch("back");
  v.frames(1);
  EXPECT_EQ(v.visit->screen(), ScreenId::keepsake);
  EXPECT_EQ(pictures(v), std::vector<view::PictureId>{9});
  ASSERT_TRUE(v.key_to("keepsake.gallery"));
  v.frames(1);
  ASSERT_TRUE(v.key_to("keepsake.done"));
  v.visit->keepsake_kept("quiet blue heron");
  v.frames(0.5);
  EXPECT_FALSE(shows_gallery(v)) << "the thanks";
  ASSERT_TRUE(v.key_to("keepsake.done"));
  EXPECT_EQ(v.visit->screen(), ScreenId::attract);
}

TEST(Gallery, APotSaysWhatItAnswersAndHowAlikeItIsAndNothingElse) {
  Visitor v;
  v.keep_today(2);
  v.todays[1].vessel = "not on the shelf any more";
  v.show();
  v.touch("attract.gallery");
  v.frames(1);
  // The stars are drawn, and spoken as words.
  std::string words;
  for (const std::string& one : v.visit->reading().words) words += one + "\n";
  EXPECT_NE(words.find(v.vessels[0].labels["en"].title), std::string::npos);
  EXPECT_NE(words.find("0 out of 5"), std::string::npos);
  EXPECT_NE(words.find("1 out of 5"), std::string::npos);
  EXPECT_EQ(words.find("any more"), std::string::npos);
}

TEST(Gallery, APotThatAnswersADescriptionIsCalledByItsMission) {
  Visitor v(9, nullptr, false, true);
  v.put_on(Visitor::described(1));
  v.keep_today(1);
  v.todays[0].vessel = "litre_jar";
  v.frames(2);
  finish_attracts_pot(v);
  ASSERT_TRUE(shows_gallery(v));
  EXPECT_NE(words_in(v.frame).find("A jar that holds a litre"), std::string::npos);
}

}  // namespace
}  // namespace onggi::screens::gallery_page_test
