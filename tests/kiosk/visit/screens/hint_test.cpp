#include "kiosk/visit/screens/hint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "kiosk/collection/score/in_words.h"
#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::hint_test {
namespace {

/// A pot beside its line, as the result would judge it.
struct Seen : HintInput {
  Seen(const Profile& line, const Profile& pot)
      : judged(score::judge(line, pot, true, 1, {}, true)) {
    target = &line;
    made = &pot;
    score = &judged;
    touched = true;
  }
  Seen(const Seen&) = delete;
  score::Score judged;
};

TEST(Hint, AWheelThatStandsStillComesBeforeAllElse) {
  const Profile target = jar(0.08), made = jar(0.05);
  Seen in(target, made);
  in.wheel_turns = false;
  EXPECT_EQ(next_hint(in).key, "hint.wheel_still");
}

TEST(Hint, AWallThatIsBuiltComesBeforeItsShape) {
  const Profile target = jar(0.08);
  Profile low = jar(0.05);
  for (ProfilePoint& p : low.points) p.height *= 0.2;
  Seen in(target, low);
  in.built.emplace().lacks_a_ring = true;
  in.coil_held = true;
  EXPECT_EQ(next_hint(in).key, "hint.lay_coil");
  in.coil_held = false;
  in.tools_way = "tool.flat_rib";
  EXPECT_EQ(next_hint(in).key, "hint.take_coil");
  EXPECT_EQ(next_hint(in).place, "tool.flat_rib") << "the name on the button";
  const Profile high = jar(0.05);
  Seen built(target, high);
  built.built.emplace();
  built.coil_held = true;
  EXPECT_EQ(next_hint(built).key, "hint.high_enough");
  built.coil_held = false;
  EXPECT_EQ(next_hint(built).key, "hint.press_out") << "as of any pot";
}

TEST(Hint, AWallOfRingsIsBeatenUntilItIsThinAndOnTheLine) {
  const Profile target = jar(0.08), made = jar(0.07);
  Seen in(target, made);
  in.built.emplace().to_beat = true;
  in.tools_way = "throw.tools";
  EXPECT_EQ(next_hint(in).key, "hint.take_paddle");
  in.paddle_held = true;
  in.built->worst = Hint::Press{0.12, true};
  EXPECT_EQ(next_hint(in).key, "hint.beat");
  ASSERT_TRUE(next_hint(in).press);
  EXPECT_EQ(next_hint(in).press->height, 0.12) << "here most";
  in.built->to_beat = false;
  EXPECT_EQ(next_hint(in).key, "hint.press_out") << "too low or too high: blows help no more";
  in.built->beaten = true;
  EXPECT_EQ(next_hint(in).key, "hint.beaten");
  in.built.reset();
  EXPECT_EQ(next_hint(in).key, "hint.beat_freely") << "a thrown pot may be beaten, too";
}

TEST(Hint, ABellyTooNarrowWantsTheHandInside) {
  const Profile target = jar(0.08), made = jar(0.06);
  Seen in(target, made);
  EXPECT_EQ(next_hint(in).key, "hint.press_out");  // Two hands: one is inside.
  in.grip = device::Grip::outside;
  const Hint hint = next_hint(in);
  EXPECT_EQ(hint.key, "hint.go_inside");
  EXPECT_EQ(hint.place, "place.belly");
  ASSERT_TRUE(hint.press);
  EXPECT_FALSE(hint.press->inward);
  EXPECT_NEAR(hint.press->height, 0.1, 0.03);
  in.grip = device::Grip::inside;
  EXPECT_EQ(next_hint(in).key, "hint.press_out");
}

TEST(Hint, ANeckTooWideWantsTheHandOutside) {
  const Profile target = jar(0.08, 0.02), made = jar(0.08, 0.05);
  Seen in(target, made);
  const Hint hint = next_hint(in);
  EXPECT_EQ(hint.key, "hint.press_in");
  EXPECT_TRUE(hint.press->inward);
  in.grip = device::Grip::inside;
  EXPECT_EQ(next_hint(in).key, "hint.go_outside");
}

TEST(Hint, ThePotThatIsTheVesselIsSaidToBeClose) {
  const Profile target = jar(0.08);
  EXPECT_EQ(next_hint(Seen(target, target)).key, "hint.close");
}

TEST(Hint, ASolidFootIsNeverToBePressedOutwards) {
  const Profile target = jar(0.06, 0.05, 0.06);
  Profile made = target;
  for (ProfilePoint& p : made.points)
    if (p.height < 0.014) p.outer = 0.02, p.inner = 0;
  const Hint hint = next_hint(Seen(target, made));
  EXPECT_TRUE(hint.key == "hint.close" || hint.press->height > 0.015) << hint.key;
}

// What is said during throwing and what the result says afterwards are one measure.
TEST(Hint, WhatIsSaidAtTheWheelIsWhatTheResultSaysFirst) {
  const std::map<std::string, std::string> same{{"plain.wider", "hint.press_out"},
                                                {"plain.much_wider", "hint.press_out"},
                                                {"plain.narrower", "hint.press_in"},
                                                {"plain.much_narrower", "hint.press_in"},
                                                {"plain.belly_higher", "hint.press_out"},
                                                {"plain.belly_lower", "hint.press_out"},
                                                {"plain.taller", "mission.taller"},
                                                {"plain.lower", "mission.lower"},
                                                {"plain.opening", "hint.opening"},
                                                {"plain.even", "hint.even"},
                                                {"remark.rippled", "hint.rippled"},
                                                {"remark.not_round", "hint.not_round"},
                                                {"remark.opening_shut", "remark.opening_shut"}};
  const Profile target = jar(0.08, 0.04, 0.05);
  std::set<std::string> said;
  int pots = 0;
  for (const double belly : {0.06, 0.075, 0.08, 0.095})
    for (const double mouth : {0.025, 0.04, 0.06})
      for (const double high : {0.75, 1.0, 1.2})
        for (const double ripple : {0.0, 0.006}) {
          Profile made = resampled(jar(belly, mouth, 0.05), 300);
          for (ProfilePoint& p : made.points) {
            p.outer += ripple * std::sin(60 * p.height / 0.2);
            p.inner = std::min(p.inner, 0.9 * p.outer);
            p.height *= high;
          }
          const Seen in(target, made);
          if (in.judged.try_next.empty()) continue;
          const score::Remark first = score::in_words(in.judged.try_next[0]);
          const Hint hint = next_hint(in);
          if (hint.key == "hint.close") continue;
          EXPECT_EQ(hint.key, same.at(first.key)) << belly << " " << mouth << " " << high;
          if (first.places.contains("place")) {
            EXPECT_EQ(hint.place, "place." + first.places.at("place"));
          }
          said.insert(hint.key);
          ++pots;
        }
  EXPECT_GT(pots, 60);
  EXPECT_GE(said.size(), 5u);
}

TEST(Hint, APotThatEndsBelowTheLineIsPulledUpAndNotPressedIn) {
  const Profile target = jar(0.08);
  Profile made = target;
  for (ProfilePoint& p : made.points) p.height *= 0.8;
  const Hint hint = next_hint(Seen(target, made));
  EXPECT_EQ(hint.key, "mission.taller");
  EXPECT_FALSE(hint.press);
}

TEST(Hint, ASentenceStandsLongEnoughToBeRead) {
  const Profile target = jar(0.08), wide = jar(0.1), narrow = jar(0.06);
  HintLine line;
  double now = 10;
  std::string shown = line.update(now, Seen(target, wide)).key;
  int changes = 0;
  for (int i = 0; i < 300; ++i) {
    now += 1.0 / 30;
    const std::string newest = line.update(now, Seen(target, i % 2 ? wide : narrow)).key;
    changes += newest != shown;
    shown = newest;
  }
  EXPECT_LE(changes, 5);
}

}  // namespace
}  // namespace onggi::screens::hint_test
