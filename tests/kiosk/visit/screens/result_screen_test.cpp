#include "kiosk/visit/screens/result_screen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kiosk/picture/view/palette.h"
#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::result_screen_test {
namespace {

bool says_millimetres(const Visitor& v) {
  return words_in(v.frame).find(" mm") != std::string::npos;
}

TEST(Result, SpeaksInWordsAndTellsMillimetresToThoseWhoAsk) {
  Visitor v;
  v.make_result();
  v.frames(1);
  EXPECT_FALSE(says_millimetres(v)) << words_in(v.frame);
  EXPECT_NE(words_in(v.frame).find("Next time, make it"), std::string::npos);
  EXPECT_EQ(words_in(v.frame).find('{'), std::string::npos);
  v.touch("result.figures");
  v.frames(1);
  EXPECT_TRUE(says_millimetres(v)) << words_in(v.frame);
  v.touch("result.again");
  v.touch("leaving.go");
  v.touch("throw.done");
  v.frames(1);
  EXPECT_TRUE(says_millimetres(v)) << "the choice lasts for the visit";
  v.touch("result.figures");
  v.frames(1);
  EXPECT_FALSE(says_millimetres(v));
  v.touch("result.figures");
  v.touch("result.keep");
  v.visit->keepsake_kept("quiet blue heron");
  v.touch("keepsake.done");
  v.touch("keepsake.done");  // thanks
  v.make_result();
  v.frames(1);
  EXPECT_FALSE(says_millimetres(v)) << "and is forgotten with its visitor";
}

std::size_t arrows(const Visitor& v) {
  std::size_t heads = 0;
  for (const view::Item& item : v.frame.items)
    if (const auto* line = std::get_if<view::Line>(&item))
      if (line->colors.front() == view::kDeepCeladon && line->points.size() == 3) ++heads;
  return heads;
}

TEST(Result, AnArrowPointsToTheVesselsLineForEachDifferenceThatTheWordsSpeakOf) {
  Visitor v;
  for (ShelfCard& card : v.shelf) card.target = jar(0.14);
  v.make_result();
  v.frames(1);
  const auto& tries = v.visit->score().try_next;
  const auto seen = [&](std::size_t of) {
    return static_cast<std::size_t>(
        std::count_if(tries.begin(), tries.begin() + static_cast<std::ptrdiff_t>(of),
                      [](const score::Remark& one) { return one.seen.has_value(); }));
  };
  ASSERT_EQ(tries.size(), 3u);
  ASSERT_TRUE(tries.front().seen);
  ASSERT_GT(seen(3), 1u);
  EXPECT_EQ(arrows(v), 1u) << "one sentence, one arrow";
  v.touch("result.figures");
  v.frames(1);
  EXPECT_EQ(arrows(v), seen(2)) << "two sentences";
}

// It was told to be narrower at the rim.
TEST(Result, APotOfTooFewRingsIsToldToHaveMore) {
  Visitor v;
  for (ShelfCard& card : v.shelf) {
    card.wheel.coil = 0.013;
    for (ProfilePoint& p : card.target.points) p.height *= 3.0;
  }
  v.make_result();
  v.frames(1);
  EXPECT_NE(words_in(v.frame).find("lay more rings"), std::string::npos) << words_in(v.frame);
  EXPECT_EQ(arrows(v), 0u) << "no part of it is too wide";
  // All rings are laid; a pot that is not yet beaten is lower than its vessel.
  Visitor laid;
  const double wide = laid.clay.mean_outer(laid.clay.rows() - 1), high = laid.clay.rim_height();
  for (ShelfCard& card : laid.shelf) {
    card.wheel.coil = 0.013;
    card.wheel.beating.emplace();
    card.target.points = {{0.0, wide, 0.0}, {1.3 * high, wide, wide - 0.003}};
  }
  laid.make_result();
  laid.frames(1);
  EXPECT_EQ(words_in(laid.frame).find("lay more rings"), std::string::npos) << words_in(laid.frame);
}

TEST(Result, APotThatIsNotKeptIsNotLeftWithoutAQuestion) {
  for (const std::string way : {"result.other", "result.again", "result.onward"}) {
    Visitor v(3);
    for (std::size_t i = 0; i < 3; ++i)
      v.shelf[i].target = jar(0.14 - 0.04 * static_cast<double>(i));
    v.make_result();
    v.frames(1);
    v.touch(way);
    EXPECT_EQ(v.visit->screen(), ScreenId::result) << way;
    ASSERT_EQ(v.visit->reading().over, "leaving") << way;
    EXPECT_EQ(v.visit->reading().first, "leaving.close") << "the safe way comes first";
    v.touch("leaving.close");
    EXPECT_EQ(v.visit->reading().over, "");
    EXPECT_EQ(v.visit->screen(), ScreenId::result);
    v.touch(way);
    v.touch("leaving.go");
    v.frames(1);
    EXPECT_EQ(v.visit->screen(), way == "result.again" ? ScreenId::throwing : ScreenId::choose);
    EXPECT_EQ(v.visit->reading().over, "");
  }
}

TEST(Result, AKeptPotIsLeftWithoutAQuestionUntilItIsTouchedAgain) {
  Visitor v;
  v.make_result();
  v.touch("result.keep");
  v.visit->keepsake_kept("2026-05-04_141503");
  v.touch("back");
  v.touch("back");
  ASSERT_EQ(v.visit->screen(), ScreenId::throwing);
  v.touch("back");
  EXPECT_EQ(v.visit->screen(), ScreenId::choose) << "it is kept";

  Visitor w;
  w.make_result();
  w.touch("result.keep");
  w.visit->keepsake_kept("2026-05-04_141503");
  w.touch("back");
  w.touch("back");
  w.touch_clay();
  w.touch("back");
  EXPECT_EQ(w.visit->reading().over, "leaving") << "it is another pot now";
}

TEST(Result, NothingToTryHasNoArrow) {
  Visitor v;
  for (ShelfCard& card : v.shelf) card.target = v.clay.profile();
  v.make_result();
  v.frames(1);
  ASSERT_EQ(v.visit->score().stars, 5);
  for (const view::Item& item : v.frame.items)
    if (const auto* line = std::get_if<view::Line>(&item)) {
      EXPECT_FALSE(line->colors.front() == view::kDeepCeladon);
    }
}

TEST(ResultScreen, AFiredPotIsNotOfferedTheFireAgain) {
  Visitor v(9, nullptr, true);
  v.make_result();
  v.frames(1);
  EXPECT_NE(words_in(v.frame).find("Glaze and fire it"), std::string::npos);
  v.glaze_and_fire();
  v.touch("back");
  v.frames(1);
  ASSERT_EQ(v.visit->screen(), ScreenId::result);
  EXPECT_EQ(words_in(v.frame).find("Glaze and fire it"), std::string::npos);
  EXPECT_NE(words_in(v.frame).find("Back to the glazes"), std::string::npos);
  v.touch("result.keep");
  EXPECT_TRUE(v.visit->control("kiln.keep"));
}

}  // namespace
}  // namespace onggi::screens::result_screen_test
