#include "kiosk/exhibit/composition/turntable_recorder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/kiosk/exhibit/composition/no_renderer.h"

namespace onggi::exhibit::turntable_recorder_test {
namespace {

constexpr double kAround = 6.283185307179586;

/// Remembers how far the pot was turned in each picture, of four pixels.
class AngleKeeper final : public test::NoRenderer {
 public:
  view::Image draw_offscreen(const view::Frame& frame) override {
    angles.push_back(frame.pot->clay_angle);
    finish = frame.pot->finish;
    return {2, 2, std::vector<std::uint8_t>(16, static_cast<std::uint8_t>(angles.size()))};
  }
  std::vector<double> angles;
  view::Finish finish = view::Finish::clay;
};

ClayView lump() {
  ClayView clay;
  ClayDef def;
  def.rows = 20;
  def.sectors = 12;
  clay.lay(def);
  return clay;
}

TEST(TurntableRecorder, GoesOnceRoundTheWayThatItsVisitorsWheelDidAndEndsWhereItBegan) {
  for (const bool left_handed : {false, true}) {
    const ClayView clay = lump();
    TurntableRecorder pot;
    AngleKeeper keeper;
    pot.begin(7, {}, clay.profile(), view::Glazing{}, clay, left_handed);
    std::optional<TurntableRecorder::Drawn> drawn;
    while (pot.drawing()) {
      ASSERT_LE(keeper.angles.size(), 40u);
      drawn = pot.draw(clay, keeper);
    }
    ASSERT_TRUE(drawn);
    EXPECT_EQ(drawn->ticket, 7);
    EXPECT_EQ(drawn->turning.frames, TurntableRecorder::kPictures);
    EXPECT_EQ(drawn->turning.rgba.size(), 16u * TurntableRecorder::kPictures);
    EXPECT_EQ(drawn->turning.rgba.capacity(), drawn->turning.rgba.size()) << "no room for nothing";
    EXPECT_EQ(keeper.finish, view::Finish::fired);
    ASSERT_EQ(keeper.angles.size(), 40u);
    // A wheel for the right hand turns to greater angles: WheelCommands::wheel, WheelSpeed::send.
    const double step = (left_handed ? -kAround : kAround) / 40;
    for (std::size_t n = 0; n < 40; ++n)
      EXPECT_NEAR(keeper.angles[n], static_cast<double>(n) * step, 1e-9) << n;
  }
}

TEST(TurntableRecorder, EndsWithoutAWordWhenAnotherPotComesOnTheWheel) {
  ClayView clay = lump();
  TurntableRecorder pot;
  AngleKeeper keeper;
  pot.begin(1, {}, clay.profile(), std::nullopt, clay, false);
  EXPECT_FALSE(pot.draw(clay, keeper));
  EXPECT_TRUE(pot.drawing());
  ClayDef other;
  other.rows = 24;
  other.sectors = 12;
  clay.lay(other);
  EXPECT_FALSE(pot.draw(clay, keeper));
  EXPECT_FALSE(pot.drawing());
  EXPECT_EQ(keeper.angles.size(), 1u);
  EXPECT_EQ(keeper.finish, view::Finish::clay);
}

}  // namespace
}  // namespace onggi::exhibit::turntable_recorder_test
