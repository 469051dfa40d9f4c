#include "kiosk/visit/screens/touched_clay.h"

#include <gtest/gtest.h>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::touched_clay_test {
namespace {

struct AtFreshClay : Visitor {
  AtFreshClay() {
    put_tools_to_hand();
    throw_a_pot();
    frames(2);
  }
};

bool tells(const Visitor& v, const char* key) {
  return words_in(v.frame).find(v.languages[0].say(key)) != std::string::npos;
}
void tap_on(Visitor& v, const std::string& control) {
  const view::Rect at = *v.visit->control(control);
  v.down(at.x + at.w / 2, at.y + at.h / 2);
  v.up(at.x + at.w / 2, at.y + at.h / 2);
  v.show();
}

TEST(TouchedClay, DoneOnUntouchedClayAsksForClayFirst) {
  AtFreshClay v;
  tap_on(v, "throw.done");
  v.frames(1);
  EXPECT_EQ(v.visit->screen(), ScreenId::throwing);
  EXPECT_TRUE(tells(v, "throw.first"));
  for (ShelfCard& card : v.shelf) card.wheel.wire = 7;
  v.touch("throw.tool.8");  // the wire would stop the wheel and cut the lump off
  EXPECT_GT(v.wheel_commands.wheels.back(), 0);
  v.frames(3);
  EXPECT_EQ(v.visit->screen(), ScreenId::throwing);
  v.touch_clay();
  EXPECT_FALSE(tells(v, "throw.first")) << "it is done";
  tap_on(v, "throw.done");
  EXPECT_EQ(v.visit->screen(), ScreenId::result);
  // And the pot is still a touched one for a visitor who comes back to it.
  v.touch("back");
  tap_on(v, "throw.done");
  EXPECT_EQ(v.visit->screen(), ScreenId::result);
}

TEST(TouchedClay, AFreshLumpAndOneWhoseStrokesAreAllUndoneCountAsUntouched) {
  AtFreshClay v;
  const auto done_leads_on = [&] {
    tap_on(v, "throw.done");
    const bool on = v.visit->screen() == ScreenId::result;
    if (on) v.touch("back");
    return on;
  };
  v.status.can_restore = true;
  v.touch_clay();
  EXPECT_TRUE(done_leads_on());
  v.touch("throw.renew");
  EXPECT_FALSE(done_leads_on()) << "new clay";
  v.touch("throw.restore");
  EXPECT_TRUE(done_leads_on()) << "the pot came back";
  v.touch("throw.restore");
  v.status.can_restore = false;
  v.show();
  EXPECT_FALSE(done_leads_on()) << "nothing is left of what was done";
  v.touch_clay();
  EXPECT_TRUE(done_leads_on());
}

TEST(TouchedClay, ATouchedPotIsNotLeftForTheShelfWithoutAQuestion) {
  AtFreshClay v;
  v.touch_clay();
  v.touch("throw.tools");
  v.touch("back");
  EXPECT_EQ(v.visit->reading().over, "") << "Back closes the drawer";
  v.touch("back");
  ASSERT_EQ(v.visit->reading().over, "leaving");
  v.key(view::Key::back);
  EXPECT_EQ(v.visit->reading().over, "");
  EXPECT_EQ(v.visit->screen(), ScreenId::throwing);
  v.key(view::Key::back);
  ASSERT_EQ(v.visit->reading().over, "leaving") << "by keys too";
  v.touch("leaving.go");
  EXPECT_EQ(v.visit->screen(), ScreenId::choose);
  v.touch("choose.card.1");
  v.touch("choose.throw");
  v.frames(1);
  v.touch("back");
  EXPECT_EQ(v.visit->screen(), ScreenId::choose) << "an untouched lump is nobody's loss";
}

}  // namespace
}  // namespace onggi::screens::touched_clay_test
