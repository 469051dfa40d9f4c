#include "kiosk/visit/screens/side_by_side.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kiosk/picture/view/palette.h"
#include "tests/kiosk/visit/screens/layout_check.h"

namespace onggi::screens::side_by_side_test {
namespace {

constexpr std::pair<int, int> kSizes[] = {{1280, 720}, {1920, 1080}, {1080, 1920}, {1024, 600}};

/// At the result, with a vessel of the shape that `target` has.
void see_result(Visitor& v, const Profile& target) {
  for (ShelfCard& card : v.shelf) card.target = target;
  v.show();
  v.make_result();
  v.frames(1);
}

view::Rect reach(const view::Camera& camera, double height, double radius) {
  float left = 1e9f, right = -1e9f, top = 1e9f, bottom = -1e9f;
  for (int i = 0; i < 32; ++i)
    for (const double y : {0.0, height}) {
      const double a = i * 0.19634954;
      const auto at = *camera.project({radius * std::cos(a), y, radius * std::sin(a)});
      left = std::min(left, at.first), right = std::max(right, at.first);
      top = std::min(top, at.second), bottom = std::max(bottom, at.second);
    }
  return {left, top, right - left, bottom - top};
}

bool meet(const view::Rect& a, const view::Rect& b) {
  return a.x < b.x + b.w && b.x < a.x + a.w && a.y < b.y + b.h && b.y < a.y + a.h;
}

std::vector<view::Rect> words_of(const Visitor& v) {
  std::vector<view::Rect> all;
  for (const view::Item& item : v.frame.items)
    if (const auto* text = std::get_if<view::Text>(&item)) {
      const auto size = v.plain.measure(text->text, text->style, text->box.w);
      const float aside =
          text->style.align == view::Align::centre ? (text->box.w - size.width) / 2 : 0;
      all.push_back({text->box.x + aside, text->box.y, size.width, size.height});
    }
  return all;
}

TEST(SideBySide, VesselAndPotHaveOneScaleAndOneLightAndNothingCoversThem) {
  for (const auto& [width, height] : kSizes)
    for (const bool left_handed : {false, true})
      for (const double belly : {0.05, 0.09, 0.17}) {
        Visitor v;
        v.width = width, v.height = height;
        v.exhibit.screen.left_handed = left_handed;
        see_result(v, jar(belly));
        ASSERT_TRUE(v.frame.pot && v.frame.pot->beside);
        view::Camera moved = v.frame.pot->beside->camera;
        moved.centre_x = v.frame.pot->camera.centre_x;
        EXPECT_EQ(moved, v.frame.pot->camera) << "but for its place";
        EXPECT_FALSE(v.frame.pot->wheel);
        const double radius = std::max(jar(belly).max_radius(), v.clay.profile().max_radius());
        const double tall = std::max(0.2, v.clay.profile().height());
        const view::Rect pot = reach(v.frame.pot->camera, tall, radius);
        const view::Rect vessel = reach(v.frame.pot->beside->camera, tall, radius);
        EXPECT_FALSE(meet(pot, vessel));
        for (const view::Rect& at : {pot, vessel}) {
          EXPECT_GE(at.x, -1);
          EXPECT_GE(at.y, -1);
          EXPECT_LE(at.x + at.w, static_cast<float>(width) + 1);
          for (const view::Rect& words : words_of(v)) {
            EXPECT_FALSE(meet(at, words)) << width;
          }
          for (const auto& [id, rect] : v.visit->controls()) {
            EXPECT_EQ(meet(at, rect), id == "result.turn") << id;
          }
          for (const view::Item& item : v.frame.items)
            if (const auto* line = std::get_if<view::Line>(&item))
              for (const auto& [x, y] : line->points) {
                EXPECT_FALSE(at.contains(x, y)) << width << ": the drawing lies over a pot";
              }
        }
      }
}

TEST(SideBySide, TheDrawingHasBothOutlinesOneWholeAndOneDashed) {
  for (const auto& [width, height] : kSizes) {
    Visitor v;
    v.width = width, v.height = height;
    see_result(v, jar(0.09));
    std::size_t whole = 0, dashes = 0;
    float left = 1e9f, right = 0, foot = 0;
    for (const view::Item& item : v.frame.items)
      if (const auto* line = std::get_if<view::Line>(&item)) {
        if (line->points.size() > 150) ++whole;
        if (line->colors.front() == view::kIron) ++dashes;
        for (const auto& [x, y] : line->points) {
          left = std::min(left, x), right = std::max(right, x), foot = std::max(foot, y);
          for (const view::Rect& words : words_of(v)) {
            EXPECT_FALSE(words.contains(x, y)) << width;
          }
          for (const auto& [id, rect] : v.visit->controls()) {
            EXPECT_TRUE(id == "language" || !rect.contains(x, y)) << id;  // the globe is lines
          }
        }
      }
    EXPECT_EQ(whole, 1u) << "the vessel's line goes on";
    EXPECT_GT(dashes, 40u) << "the pot's is dashed";
    EXPECT_LE(right, static_cast<float>(width));
    EXPECT_LE(foot, static_cast<float>(height));
    EXPECT_GE(left, 0);
  }
}

TEST(SideBySide, ADragTurnsBothByAsMuch) {
  Visitor v;
  v.exhibit.screen.reduced_motion = true;
  see_result(v, jar(0.09));
  const auto angles = [&] {
    return std::pair(v.frame.pot->clay_angle, v.frame.pot->beside->angle);
  };
  const auto before = angles();
  v.frames(3);
  EXPECT_EQ(angles(), before) << "with less motion they stand";
  v.move(900, 300);
  v.show();
  EXPECT_EQ(angles(), before) << "a mouse that is not held turns nothing";
  v.down(900, 300);
  v.move(960, 310);
  v.show();
  const double by = angles().second - before.second;
  EXPECT_GT(std::abs(by), 0.2);
  EXPECT_NEAR(angles().first - before.first, by, 1e-12);
  v.up(960, 310);
  v.move(1000, 310);
  v.show();
  EXPECT_NEAR(angles().second - before.second, by, 1e-12) << "let go";
  EXPECT_EQ(v.visit->screen(), ScreenId::result);
}

TEST(SideBySide, TheyTurnSlowlyByThemselvesAndNotUnderAFinger) {
  Visitor v;
  see_result(v, jar(0.09));
  const double before = v.frame.pot->beside->angle;
  v.frames(1);
  EXPECT_NEAR(std::abs(v.frame.pot->beside->angle - before), 0.8, 0.03);
  v.down(900, 300);
  const double held = v.frame.pot->beside->angle;
  v.frames(1);
  EXPECT_EQ(v.frame.pot->beside->angle, held);
}

// A picture that stands is drawn in full quality. While they turned for good, the vessel had
// stairs.
TEST(SideBySide, TheyTurnOnceAndThenStandAsTheyBegan) {
  Visitor v;
  see_result(v, jar(0.09));
  const auto angle = [&] { return v.frame.pot->beside->angle; };
  const double before = angle();
  v.frames(7.0);
  EXPECT_GT(std::abs(angle() - before), 0.1) << "still on the way";
  v.frames(2.0);
  const double stands = angle();
  EXPECT_NEAR(std::remainder(stands, 6.283185307179586), 0.0, 1e-9);
  v.frames(5.0);
  EXPECT_EQ(angle(), stands);
}

TEST(SideBySide, ComingBackFromTheKilnThePotWearsItsGlaze) {
  Visitor v(3, nullptr, true);
  see_result(v, jar(0.09));
  EXPECT_EQ(v.frame.pot->finish, view::Finish::clay);
  v.glaze_and_fire();
  v.touch("back");
  v.frames(1);
  ASSERT_EQ(v.visit->screen(), ScreenId::result);
  EXPECT_EQ(v.frame.pot->finish, view::Finish::fired);
  EXPECT_EQ(v.frame.pot->glazing.look, v.glazes[1].look);
  EXPECT_EQ(v.frame.pot->size, 1.0) << "shapes are compared as they were thrown";
}

TEST(SideBySide, UnderHelpThePotsStandWhereAScreenOfAnotherSizeHasThem) {
  for (const bool mirrors : {false, true}) {
    Visitor v;
    see_result(v, jar(0.09));
    v.touch("help");
    v.show();
    if (mirrors)
      v.exhibit.screen.left_handed = true;
    else
      v.width = 1080, v.height = 1920;
    v.show();
    ASSERT_TRUE(v.frame.pot && v.frame.pot->beside);
    const view::PotView under = *v.frame.pot;
    v.touch("help.close");
    v.frames(1);
    const view::PotView open = *v.frame.pot;
    EXPECT_EQ(under.camera.width, open.camera.width);
    EXPECT_NEAR(under.camera.centre_x, open.camera.centre_x, 1);
    EXPECT_NEAR(under.camera.centre_y, open.camera.centre_y, 1);
    EXPECT_NEAR(under.camera.distance, open.camera.distance, 1e-3);
    EXPECT_NEAR(under.beside->camera.centre_x, open.beside->camera.centre_x, 1);
  }
}

}  // namespace
}  // namespace onggi::screens::side_by_side_test
