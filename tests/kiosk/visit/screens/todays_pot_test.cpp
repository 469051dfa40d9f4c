#include "kiosk/visit/screens/todays_pot.h"

#include <gtest/gtest.h>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::todays_pot_test {
namespace {

std::vector<TodaysPot> pots(const std::vector<std::string>& vessels) {
  std::vector<TodaysPot> all;
  for (std::size_t i = 0; i < vessels.size(); ++i)
    all.push_back({1, vessels[i], 3, "visit " + std::to_string(i)});
  return all;
}

TEST(TodaysPots, AreCountedFromTheFirstOfTheDayVesselByVessel) {
  // The newest first: the jars are numbers 3, 2 and 1.
  const auto today = pots({"jar", "bowl", "jar", "bowl", "jar"});
  EXPECT_EQ(number_today(today, "visit 0"), 3);
  EXPECT_EQ(number_today(today, "visit 2"), 2);
  EXPECT_EQ(number_today(today, "visit 3"), 1);
  EXPECT_EQ(number_today(today, "gone"), 0);
  EXPECT_EQ(number_today(pots(std::vector<std::string>(kMostTodays, "jar")), "visit 0"), 0)
      << "older ones may be missing";
}

TEST(TodaysPots, TheKeepsakeSaysANumberOfFiveOrMoreAndNoSmallerOne) {
  for (const int older : {3, 4}) {
    Visitor v(1);
    v.keep_today(older);
    v.make_result();
    v.touch("result.keep");
    v.visit->show_postcard(9);
    v.todays.insert(v.todays.begin(), {9, v.vessels[0].id, 4, "mine"});
    v.visit->keepsake_kept("quiet blue heron", "", "mine");
    v.frames(1);
    const std::string words = words_in(v.frame);
    EXPECT_NE(words.find("quiet blue heron"), std::string::npos);
    EXPECT_EQ(words.find("number 5 today") != std::string::npos, older == 4) << words;
    EXPECT_EQ(words.find("number 4"), std::string::npos);
  }
}

}  // namespace
}  // namespace onggi::screens::todays_pot_test
