#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tests/kiosk/picture/render/studio_fixture.h"

// What a pot looks like whose wall tore.

namespace onggi::render::testing::torn_test {
namespace {

using Torn = StudioTest;

const ClayDef kShape = grid_of(600, 256, 0.20, 0.010);
// The tear below is between these heights; what is torn of the wall gapes up to 1 cm about it.
constexpr int kFrom = 372, kTo = 384;
constexpr double kLow = 0.124 - 0.010, kHigh = 0.128 + 0.010;

double jar(double t) { return 0.045 + 0.022 * std::sin(3.14159 * (0.10 + 0.80 * t)); }

ClayView jar_clay(double wall = 0.003) { return thrown_clay(kShape, jar, wall, 0.00015); }

/// Rows from..to of the jar on the wheel tear.
void put_jar(Renderer& r, int from = 0, int to = 0, double wall = 0.003) {
  ClayView clay = jar_clay(wall);
  tear(clay, from, to);
  r.show_clay(clay);
}

view::Frame jar_frame(int width = 1280, int height = 720) {
  view::Frame frame = frame_with_pot(width, height, kShape.height, 0.067);
  frame.pot->wheel_angle = frame.pot->clay_angle = 1.0;
  return frame;
}

struct Difference {
  int pixels = 0, top = 1 << 20, bottom = -1;
};
Difference between(const view::Image& a, const view::Image& b) {
  Difference d;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const Pixel p = pixel_at(a, x, y), q = pixel_at(b, x, y);
      // Another program may round the last bit of a colour otherwise.
      if (std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)}) < 3) continue;
      ++d.pixels;
      d.top = std::min(d.top, y);
      d.bottom = std::max(d.bottom, y);
    }
  return d;
}

/// Dry, wet, glazed, and half-way to its glaze.
std::vector<view::PotView> in_all_skins(const view::PotView& pot) {
  std::vector<view::PotView> all(4, pot);
  all[1].wetness = 0.8;
  all[2].finish = view::Finish::fired;
  all[3].finish = view::Finish::firing;
  all[3].firing = {std::nullopt, 0.5, 0.6};
  return all;
}

TEST_F(Torn, APotWithTornRingsIsDrawnBrokenThereAndNowhereElse) {
  Renderer& r = renderer();
  view::Frame frame = jar_frame();
  const view::Camera& camera = frame.pot->camera;
  // The wall's near and far side, as they lie on the picture.
  const double top = std::min(camera.project({0, kHigh, 0.067})->second,
                              camera.project({0, kHigh, -0.067})->second);
  const double bottom =
      std::max(camera.project({0, kLow, 0.067})->second, camera.project({0, kLow, -0.067})->second);
  int skin = 0;
  for (const view::PotView& pot : in_all_skins(*frame.pot)) {
    for (const double open : {0.0, 1.0}) {
      frame.pot = pot;
      frame.pot->cut_away = open;
      put_jar(r);
      const view::Image whole = r.draw_offscreen(frame);
      put_jar(r, kFrom, kTo);
      const Difference d = between(whole, r.draw_offscreen(frame));
      EXPECT_GT(d.pixels, 1500) << "skin " << skin << ", open " << open;
      EXPECT_GE(d.top, top) << "skin " << skin << ", open " << open;
      EXPECT_LE(d.bottom, bottom) << "skin " << skin << ", open " << open;
    }
    ++skin;
  }
}

TEST_F(Torn, WhatIsBehindIsSeenThroughTheTear) {
  Renderer& r = renderer();
  view::Frame frame = jar_frame();
  frame.pot->cut_away = 1.0;
  r.show_clay({});  // the wheel alone
  const view::Image behind = r.draw_offscreen(frame);
  const auto seen_through = [&] {
    const view::Image image = r.draw_offscreen(frame);
    // Of the far wall, in the quarter that the cut opens to.
    const auto low = *frame.pot->camera.project({0, kLow, -0.06});
    const auto high = *frame.pot->camera.project({0.05, kHigh, -0.03});
    int count = 0;
    for (int y = static_cast<int>(high.second); y < static_cast<int>(low.second); ++y)
      for (int x = static_cast<int>(low.first); x < static_cast<int>(high.first); ++x) {
        const Pixel p = pixel_at(image, x, y), q = pixel_at(behind, x, y);
        count += std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b) < 4 ? 1 : 0;
      }
    return count;
  };
  put_jar(r);
  EXPECT_EQ(seen_through(), 0);
  put_jar(r, kFrom, kTo);
  EXPECT_GT(seen_through(), 300);
}

TEST_F(Torn, ARingThatHealsAndAFreshPotAreDrawnAsIfNothingHadEverTorn) {
  Renderer& r = renderer();
  const view::Frame frame = jar_frame();
  put_jar(r);
  const view::Image whole = r.draw_offscreen(frame);
  ClayView clay = jar_clay();
  tear(clay, kFrom, kTo);
  r.show_clay(clay);
  EXPECT_NE(r.draw_offscreen(frame).rgba, whole.rgba);
  tear(clay, kFrom, kTo, false);
  r.update_clay(clay);
  EXPECT_EQ(r.draw_offscreen(frame).rgba, whole.rgba);
  put_jar(r, kFrom, kTo);
  put_jar(r);
  EXPECT_EQ(r.draw_offscreen(frame).rgba, whole.rgba);
}

TEST_F(Torn, ATearGoesWhereItsRowsGo) {
  Renderer& r = renderer();
  const view::Frame frame = jar_frame();
  const auto middle_of_tear = [&](double higher) {
    ClayView clay = jar_clay();
    for (int j = 0; j < clay.rows(); ++j)
      clay.place(j,
                 {clay.row_height(j) + (j >= 300 ? higher : 0.0), 0.2 + higher, 0.010, 30, false});
    r.show_clay(clay);
    const view::Image whole = r.draw_offscreen(frame);
    tear(clay, kFrom, kTo);
    r.update_clay(clay);
    const Difference d = between(whole, r.draw_offscreen(frame));
    return 0.5 * (d.top + d.bottom);
  };
  const view::Camera& camera = frame.pot->camera;
  EXPECT_NEAR(middle_of_tear(0.0) - middle_of_tear(0.015),
              camera.project({0, 0.126, 0.067})->second - camera.project({0, 0.141, 0.067})->second,
              9.0);
}

TEST_F(Torn, OneTornRowOfAGridFinerThanThePictureIsSeen) {
  Renderer& r = renderer();
  const ClayDef fine = grid_of(4500, 64, 0.20, 0.010);
  ClayView clay = thrown_clay(fine, jar, 0.003, 0.0);
  const view::Frame frame = jar_frame();
  r.show_clay(clay);
  const view::Image whole = r.draw_offscreen(frame);
  for (const int row : {2800, 2801}) {
    tear(clay, row, row + 1);
    r.update_clay(clay);
    EXPECT_GT(between(whole, r.draw_offscreen(frame)).pixels, 300) << row;
    tear(clay, row, row + 1, false);
  }
}

// For people to look at.
TEST_F(Torn, TearsInAllSkinsWholeAndCutOpen) {
  Renderer& r = renderer();
  const char* const names[] = {"dry", "wet", "glazed", "firing"};
  for (const bool tall : {false, true}) {
    view::Frame frame = tall ? jar_frame(1080, 1920) : jar_frame();
    const std::string size = tall ? "_tall" : "";
    put_jar(r, kFrom, kTo);
    const auto skins = in_all_skins(*frame.pot);
    for (std::size_t k = 0; k < skins.size(); ++k) {
      frame.pot = skins[k];
      keep_for_looking(r.draw_offscreen(frame), std::string("torn_") + names[k] + size);
      frame.pot->cut_away = 1.0;
      keep_for_looking(r.draw_offscreen(frame), std::string("torn_") + names[k] + "_open" + size);
    }
    frame.pot = skins[0];
    put_jar(r, 400, 402);
    keep_for_looking(r.draw_offscreen(frame), "torn_thin" + size);
    put_jar(r, 300, 390, 0.006);
    keep_for_looking(r.draw_offscreen(frame), "torn_wide" + size);
    put_jar(r, 582, 600);
    frame.pot->camera.elevation = 0.45;
    keep_for_looking(r.draw_offscreen(frame), "torn_rim" + size);
  }
}

}  // namespace
}  // namespace onggi::render::testing::torn_test
