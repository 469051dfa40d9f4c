#include "kiosk/visit/screens/hint.h"

#include <gtest/gtest.h>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens {
namespace {

HintInput seen(const Profile& target, const Profile& made) {
  HintInput in;
  in.target = &target;
  in.made = &made;
  in.touched = true;
  return in;
}

TEST(Hint, AWheelThatStandsStillComesBeforeAllElse) {
  const Profile target = jar(0.08), made = jar(0.05);
  HintInput in = seen(target, made);
  in.wheel_turns = false;
  EXPECT_EQ(next_hint(in).key, "hint.wheel_still");
}

TEST(Hint, ABellyTooNarrowWantsTheHandInside) {
  const Profile target = jar(0.08), made = jar(0.06);
  HintInput in = seen(target, made);
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
  HintInput in = seen(target, made);
  const Hint hint = next_hint(in);
  EXPECT_EQ(hint.key, "hint.press_in");
  EXPECT_TRUE(hint.press->inward);
  in.grip = device::Grip::inside;
  EXPECT_EQ(next_hint(in).key, "hint.go_outside");
}

TEST(Hint, ThePotThatIsTheVesselIsSaidToBeClose) {
  const Profile target = jar(0.08);
  EXPECT_EQ(next_hint(seen(target, target)).key, "hint.close");
}

TEST(Hint, ASolidFootIsNeverToBePressedOutwards) {
  const Profile target = jar(0.06, 0.05, 0.06);
  Profile made = target;
  for (ProfilePoint& p : made.points)
    if (p.height < 0.014) p.outer = 0.02, p.inner = 0;
  const Hint hint = next_hint(seen(target, made));
  EXPECT_TRUE(hint.key == "hint.close" || hint.press->height > 0.015) << hint.key;
}

TEST(Hint, ASentenceStandsLongEnoughToBeRead) {
  const Profile target = jar(0.08), wide = jar(0.1), narrow = jar(0.06);
  HintLine line;
  double now = 10;
  std::string shown = line.update(now, seen(target, wide)).key;
  int changes = 0;
  for (int i = 0; i < 300; ++i) {
    now += 1.0 / 30;
    const std::string newest = line.update(now, seen(target, i % 2 ? wide : narrow)).key;
    changes += newest != shown;
    shown = newest;
  }
  EXPECT_LE(changes, 5);
}

}  // namespace
}  // namespace onggi::screens
