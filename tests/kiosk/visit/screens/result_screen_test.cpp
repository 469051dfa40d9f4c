#include "kiosk/visit/screens/result_screen.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kiosk/picture/view/palette.h"
#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens {
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
  v.touch("throw.done");
  v.frames(1);
  EXPECT_TRUE(says_millimetres(v)) << "the choice lasts for the visit";
  v.touch("result.figures");
  v.frames(1);
  EXPECT_FALSE(says_millimetres(v));
  v.touch("result.figures");
  v.touch("result.keep");
  v.touch("keepsake.done");
  v.make_result();
  v.frames(1);
  EXPECT_FALSE(says_millimetres(v)) << "and is forgotten with its visitor";
}

TEST(Result, AnArrowPointsToTheVesselsLineForEachDifferenceThatIsSeen) {
  // A lump is narrower than a wide jar: arrows point outwards, to the right of the axis.
  Visitor v;
  for (ShelfCard& card : v.shelf) card.target = jar(0.14);
  v.make_result();
  v.frames(1);
  std::size_t seen = 0;
  for (const score::Remark& one : v.visit->score().try_next) seen += one.seen ? 1 : 0;
  ASSERT_GT(seen, 0u);
  std::size_t heads = 0;
  for (const view::Item& item : v.frame.items)
    if (const auto* line = std::get_if<view::Line>(&item))
      if (line->colors.front() == view::kDeepCeladon && line->points.size() == 3) ++heads;
  EXPECT_EQ(heads, seen);
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

}  // namespace
}  // namespace onggi::screens
