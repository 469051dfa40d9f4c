#include "kiosk/lab/measure/headless_visit.h"

#include <gtest/gtest.h>

namespace onggi::measure::headless_visit_test {
namespace {

const HeadlessVisits& visits() {
  static const auto kOpened = HeadlessVisits::open("config/exhibit.toml");
  return **kOpened;
}

TEST(HeadlessVisits, TheSameSeedThrowsTheSamePotAndAnotherAnother) {
  const int card = *visits().card_of("moon_jar");
  const auto throw_one = [&](std::uint64_t seed) {
    return visits().naive(card, seed, rehearsal::NaiveHands::Pointer::mouse, {5, 8}).value();
  };
  const HeadlessOutcome one = throw_one(1), again = throw_one(1), other = throw_one(2);
  ASSERT_EQ(one.looks.size(), 2u);
  for (std::size_t n = 0; n < 2; ++n) {
    EXPECT_EQ(one.looks[n].points, again.looks[n].points);
    EXPECT_EQ(one.looks[n].out_of_round, again.looks[n].out_of_round);
  }
  EXPECT_NE(one.looks[1].points, other.looks[1].points);
  EXPECT_EQ(one.looks[0].seconds, 5);
  EXPECT_NE(one.looks[0].points, one.looks[1].points) << "the pot of the fifth second is its own";
}

// A pot is looked at on its way: what comes later changes nothing of that.
TEST(HeadlessVisits, WhatIsSeenOnTheWayDoesNotDependOnHowLongTheVisitIs) {
  const int card = *visits().card_of("tea_bowl");
  const auto brief =
      visits().naive(card, 3, rehearsal::NaiveHands::Pointer::finger, {5, 6}).value();
  const auto longer =
      visits().naive(card, 3, rehearsal::NaiveHands::Pointer::finger, {5, 6, 9}).value();
  for (std::size_t n = 0; n < 2; ++n) {
    EXPECT_EQ(brief.looks[n].points, longer.looks[n].points);
    EXPECT_EQ(brief.looks[n].out_of_round, longer.looks[n].out_of_round)
        << "the last moment is one as any other, in the midst of a stroke";
  }
}

TEST(HeadlessVisits, AVesselThatIsNotOnTheShelfIsNamedWithItsNearest) {
  const auto card = visits().card_of("moonjar");
  ASSERT_FALSE(card);
  EXPECT_NE(card.error().remedy.find("moon_jar"), std::string::npos);
}

TEST(HeadlessVisits, ASceneThatCannotBeReadOpensNoVisits) {
  EXPECT_FALSE(HeadlessVisits::open("config/no_such_exhibit.toml"));
  EXPECT_FALSE(HeadlessVisits::open("config/exhibit.toml", "config/scenes/none.toml"));
}

}  // namespace
}  // namespace onggi::measure::headless_visit_test
