#include "kiosk/picture/view/looks_same.h"

#include <gtest/gtest.h>

namespace onggi::view::looks_same_test {
namespace {

PotView a_pot() {
  PotView pot;
  pot.wheel_angle = 0.5;
  pot.wetness_by_row = {0.1f, 0.2f};
  pot.hands[0].present = true;
  pot.beside.emplace();
  return pot;
}

TEST(LooksSame, WhatNobodySeesIsNoNewPicture) {
  PotView now = a_pot();
  now.wheel_angle += 1e-5;
  now.wetness_by_row[1] += 0.002f;
  now.hands[0].at.x += 1e-6;
  now.camera.distance += 1e-6;
  now.beside->angle += 1e-5;
  EXPECT_TRUE(looks_same(a_pot(), now));
}

TEST(LooksSame, EverythingThatIsSeenIs) {
  const auto differs = [](auto&& change) {
    PotView now = a_pot();
    change(now);
    return !looks_same(a_pot(), now);
  };
  EXPECT_TRUE(differs([](PotView& p) { p.wheel_angle += 0.01; }));
  EXPECT_TRUE(differs([](PotView& p) { p.clay_angle -= 0.01; }));
  EXPECT_TRUE(differs([](PotView& p) { p.wetness = 0.1; }));
  EXPECT_TRUE(differs([](PotView& p) { p.wetness_by_row[0] = 0.3f; }));
  EXPECT_TRUE(differs([](PotView& p) { p.wetness_by_row.push_back(0.2f); }));
  EXPECT_TRUE(differs([](PotView& p) { p.hands[0].at.y = 0.001; }));
  EXPECT_TRUE(differs([](PotView& p) { p.hands[0].present = false; }));
  EXPECT_TRUE(differs([](PotView& p) { p.hands[1].present = true; }));
  EXPECT_TRUE(differs([](PotView& p) { p.camera.azimuth = 0.1; }));
  EXPECT_TRUE(differs([](PotView& p) { p.beside.reset(); }));
  EXPECT_TRUE(differs([](PotView& p) { p.beside->angle += 0.01; }));
  EXPECT_TRUE(differs([](PotView& p) { p.beside->camera.centre_x += 1; }));
  EXPECT_TRUE(differs([](PotView& p) { p.camera.target.y += 0.001; }));
  EXPECT_TRUE(differs([](PotView& p) { p.camera.width += 1; }));
  EXPECT_TRUE(differs([](PotView& p) { p.finish = Finish::fired; }));
  EXPECT_TRUE(differs([](PotView& p) { p.glazing.look.glass[1] = 0.9f; }));
  EXPECT_TRUE(differs([](PotView& p) { p.firing.glow = 0.5; }));
  EXPECT_TRUE(differs([](PotView& p) { p.cut_away = 1; }));
  EXPECT_TRUE(differs([](PotView& p) { p.opacity = 0.5; }));
}

}  // namespace
}  // namespace onggi::view::looks_same_test
