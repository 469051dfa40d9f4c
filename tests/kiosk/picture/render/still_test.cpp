#include <chrono>
#include <thread>

#include "kiosk/picture/view/palette.h"
#include "tests/kiosk/picture/render/studio_fixture.h"

namespace onggi::render::testing::still_test {
namespace {

double flared(double t) { return 0.04 + 0.02 * t; }

/// A window whose pot has just been turning, drawn as finely as there is time for.
class APotThatComesToRest : public StudioTest {
 protected:
  void SetUp() override {
    StudioTest::SetUp();
    if (IsSkipped()) return;
    renderer().set_full_quality(false);
    renderer().show_clay(thrown_clay(grid_of(120, 120, 0.15, 0.01), flared, 0.006, 0.0005));
    frame_ = frame_with_pot(640, 400, 0.15, 0.06);
    for (int i = 0; i < 5; ++i) {
      frame_.pot->wheel_angle = frame_.pot->clay_angle = 0.2 * i;
      renderer().draw(frame_);
    }
  }
  void TearDown() override {
    if (!IsSkipped()) renderer().set_full_quality(true);
  }
  void stand(int frames) {
    for (int i = 0; i < frames; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      renderer().draw(frame_);
    }
  }
  view::Frame frame_;
};

TEST_F(APotThatComesToRest, IsDrawnInFullSoonAfter) {
  stand(4);
  EXPECT_TRUE(renderer().status().full_quality);
  EXPECT_EQ(renderer().read_pixels().rgba, renderer().draw_offscreen(frame_).rgba);
}

TEST_F(APotThatComesToRest, KeepsItsPictureWhileWordsChange) {
  stand(4);
  const view::Image before = renderer().read_pixels();
  frame_.items.emplace_back(view::Box{{10, 10, 40, 30}, 0, view::kCobalt, 0, {}});
  renderer().draw(frame_);
  view::Image after = renderer().read_pixels();
  EXPECT_TRUE(renderer().status().full_quality);
  EXPECT_EQ(pixel_at(after, 30, 20).b, 0x7C);
  EXPECT_EQ(pixel_at(after, 320, 200).r, pixel_at(before, 320, 200).r);
  frame_.items.clear();
  renderer().draw(frame_);
  EXPECT_EQ(renderer().read_pixels().rgba, before.rgba);
}

TEST_F(APotThatComesToRest, MovesAgainAtOnceWhenAHandOrTheClayDoes) {
  stand(4);
  const view::Image before = renderer().read_pixels();
  ClayView thinner = thrown_clay(grid_of(120, 120, 0.15, 0.01), flared, 0.003, 0.0);
  renderer().show_clay(thinner);
  renderer().draw(frame_);
  EXPECT_NE(renderer().read_pixels().rgba, before.rgba);
  stand(4);
  const view::Image empty_handed = renderer().read_pixels();
  frame_.pot->hands[0] = {.present = true, .radius = 0.01, .at = {0.08, 0.1, 0}};
  renderer().draw(frame_);
  EXPECT_NE(renderer().read_pixels().rgba, empty_handed.rgba);
}

// No frame of these differs from the one before it.
TEST_F(APotThatComesToRest, SlowChangesAddUp) {
  stand(4);
  const view::Image before = renderer().read_pixels();
  for (int i = 0; i < 120; ++i) {
    frame_.pot->wheel_angle = frame_.pot->clay_angle += 1e-4;
    renderer().draw(frame_);
  }
  EXPECT_NE(renderer().read_pixels().rgba, before.rgba);
}

}  // namespace
}  // namespace onggi::render::testing::still_test
