#include "kiosk/picture/render/edges.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "tests/kiosk/picture/render/decorated_jar.h"
#include "tests/kiosk/picture/render/edges_fixture.h"

namespace onggi::render::testing::edges_test {
namespace {

double edged_jar(double t) { return 0.045 + 0.035 * std::sin(0.4 + 2.5 * t); }
double edged_bowl(double t) { return 0.03 + 0.06 * std::sqrt(t); }
double edged_flare(double t) { return 0.035 + 0.05 * t * t * t * t; }
double edged_mug(double) { return 0.075; }
// A cup on a stem on a block: its rows leap where it turns level.
double edged_goblet(double t) { return t < 0.34 ? 0.075 : t < 0.7 ? 0.03 : 0.08; }
const ClayDef kEdgedJar = grid_of(240, 180, 0.20, 0.010),
              kEdgedBowl = grid_of(160, 180, 0.09, 0.010);

TEST_F(AnEdge, OfAJarIsSmooth) {
  if (renderer().status().embedded) GTEST_SKIP() << "OpenGL ES reads no depth back";
  expect_smooth(show(kEdgedJar, edged_jar, 0.20, 0.09), "jar", {{{0.38, 0.0005}, {0.24, 0.0005}}});
}

TEST_F(AnEdge, OfAWetBowlIsSmooth) {
  if (renderer().status().embedded) GTEST_SKIP() << "OpenGL ES reads no depth back";
  view::Frame frame = show(kEdgedBowl, edged_bowl, 0.09, 0.09);
  frame.pot->wetness = 0.8;
  expect_smooth(frame, "wet_bowl", {{{0.41, 0.006}, {0.27, 0.006}}});
}

TEST_F(AnEdge, OfAPaintedGlazeIsSmooth) {
  if (renderer().status().embedded) GTEST_SKIP() << "OpenGL ES reads no depth back";
  view::Frame frame = show(kEdgedJar, edged_jar, 0.20, 0.09);
  frame.pot->finish = view::Finish::fired;
  frame.pot->size = 0.9;
  frame.pot->glazing.look.band_height = 0.6f;
  frame.pot->glazing.look.band_width = 0.05f;
  expect_smooth(frame, "glazed_jar", {{{0.45, 0.001}, {0.30, 0.001}}});
}

TEST_F(AnEdge, OfAJarWithACoilIsSmooth) {
  if (renderer().status().embedded) GTEST_SKIP() << "OpenGL ES reads no depth back";
  DecoratedJar pot(0.18, 0.0);
  for (const double share : {0.35, 0.6})
    pot.lay(pot.ring(surface::CoilDef{.width = 0.008, .height = 0.003, .press = 0.3}, share));
  stage_->clay().show(pot.clay);
  stage_->coat().show(pot.draw(false));
  reference_.clear();
  view::Frame frame = frame_with_pot(kWide, kTall, 0.18, 0.07);
  frame.pot->wheel = false;
  expect_smooth(frame, "coil", {{{0.47, 0.0005}, {0.28, 0.0005}}});
  stage_->coat().show(nullptr);
}

TEST_F(AnEdge, OfAFlaredCupIsSmooth) {
  if (renderer().status().embedded) GTEST_SKIP() << "OpenGL ES reads no depth back";
  expect_smooth(show(kEdgedJar, edged_flare, 0.20, 0.09), "flare",
                {{{0.5, 0.0005}, {0.4, 0.0005}}});
}

TEST_F(AnEdge, OfATornJarIsSmooth) {
  if (renderer().status().embedded) GTEST_SKIP() << "OpenGL ES reads no depth back";
  const view::Frame frame = show(kEdgedJar, edged_jar, 0.20, 0.09);
  tear(clay_, 150, 156);
  stage_->clay().show(clay_);
  expect_smooth(frame, "torn_jar", {{{0.57, 0.001}, {0.44, 0.007}}});
}

TEST_F(AnEdge, OfAnOpenedJarIsSmooth) {
  if (renderer().status().embedded) GTEST_SKIP() << "OpenGL ES reads no depth back";
  view::Frame frame = show(kEdgedJar, edged_jar, 0.20, 0.09);
  frame.pot->cut_away = 1.0;
  expect_smooth(frame, "opened_jar", {{{0.38, 0.0005}, {0.28, 0.0005}}});
}

// An opening of a few texels was broken lines, bright and dark, and a slit beside it.
TEST_F(AnEdge, OfAPotThatClosesIsThatOfAClosedPotWhereTexelsAreTooWide) {
  view::Frame frame = show(kEdgedJar, edged_jar, 0.20, 0.09);
  for (const double scale : {0.5, 0.25}) {
    frame.pot->cut_away = 0.0;
    const view::Image closed = drawn(frame, scale);
    for (const double open : {0.05, 0.02, 0.008, 0.002}) {
      frame.pot->cut_away = open;
      EXPECT_TRUE(drawn(frame, scale).rgba == closed.rgba) << scale << " " << open;
    }
    frame.pot->cut_away = 0.3;
    EXPECT_FALSE(drawn(frame, scale).rgba == closed.rgba) << scale;
  }
}

// A finger's dent makes the wall out of round, so that a row's side is not where its mean would be.
TEST_F(AnEdge, OfADentedJarIsWhole) {
  if (renderer().status().embedded) GTEST_SKIP() << "OpenGL ES reads no depth back";
  const view::Frame frame = show(kEdgedJar, edged_jar, 0.20, 0.09);
  for (int j = 0; j < clay_.rows(); ++j) {
    std::vector<float> outer(clay_.outer(j).begin(), clay_.outer(j).end());
    const std::vector<float> inner(clay_.inner(j).begin(), clay_.inner(j).end());
    for (std::size_t i = 0; i < outer.size(); ++i) {
      // Five dents, so that some stand at the sides.
      const double up = (clay_.row_height(j) - 0.1) / 0.018,
                   round = std::sin(5.0 * 6.283185307 * static_cast<double>(i) /
                                    static_cast<double>(outer.size()));
      const double deep = 0.018 * std::clamp(2.0 - 2.0 * std::abs(up), 0.0, 1.0);
      outer[i] -= static_cast<float>(deep * std::clamp(0.5 + 2.0 * round, 0.0, 1.0));
    }
    clay_.shape(j, outer, inner);
  }
  stage_->clay().show(clay_);
  expect_smooth(frame, "dented_jar", {{{0.5, 0.0001}, {0.35, 0.0001}}});
}

TEST_F(AnEdge, OfAGobletIsWhole) {
  if (renderer().status().embedded) GTEST_SKIP() << "OpenGL ES reads no depth back";
  expect_smooth(show(kEdgedJar, edged_goblet, 0.20, 0.09), "goblet",
                {{{0.75, 0.012}, {0.55, 0.012}}});
}

// Where a lip came to be wider than a few texels, flecks stood on it, in front and behind.
TEST_F(AnEdge, OfAThickRimHasNoFlecks) {
  if (renderer().status().embedded) GTEST_SKIP() << "OpenGL ES reads no depth back";
  for (const double wall : {0.016, 0.020, 0.024, 0.028}) {
    view::Frame frame = show(kEdgedJar, edged_mug, 0.20, 0.09);
    clay_ = thrown_clay(kEdgedJar, edged_mug, wall, 0.0);
    stage_->clay().show(clay_);
    const auto rim = *frame.pot->camera.project({0, 0.2, 0});
    only_ = [&](int x, int y) {
      return std::abs(static_cast<float>(y) - rim.second) < 40 &&
             std::abs(static_cast<float>(x) - rim.first) < 80;
    };
    const std::string name = "thick_rim_" + std::to_string(std::lround(1e3 * wall));
    sample(frame, name);
    only_ = {};
    const view::Image with = drawn(frame, 0.5);
    keep_for_looking(with, "edges_" + name);
    EXPECT_LE(odd(with), 0.0002) << wall;
  }
}

// A finger before the rim, or before the wheel head's, is not painted over by the edge behind it.
TEST_F(AnEdge, BehindAFingerStaysHidden) {
  view::Frame frame = show(kEdgedJar, edged_jar, 0.20, 0.09);
  for (const Vec3 tip : {Vec3{0.0, 0.195, 0.09}, Vec3{0.0, 0.0, frame.pot->wheel_radius + 0.013}}) {
    frame.pot->hands[0] = {.present = true, .radius = 0.012, .at = tip};
    const view::Image image = drawn(frame, 0.5);
    keep_for_looking(image, "edges_behind_finger_" + std::to_string(std::lround(1e3 * tip.y)));
    renderer().show_clay(clay_);
    const view::Image full = renderer().draw_offscreen(frame);
    const auto at = *frame.pot->camera.project(tip);
    const int x = static_cast<int>(at.first), y = static_cast<int>(at.second);
    for (int i = -2; i <= 2; ++i)
      for (int j = -2; j <= 2; ++j) {
        const Pixel p = pixel_at(image, x + i, y + j), q = pixel_at(full, x + i, y + j);
        EXPECT_LT(std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b), 24) << tip.y;
      }
  }
}

// A finger fades, and what it lets show has no steps: neither the outline that it crosses, nor the
// rim where it comes out of the mouth.
TEST_F(AnEdge, BehindAFadingFingerIsSmooth) {
  if (renderer().status().embedded) GTEST_SKIP() << "OpenGL ES reads no depth back";
  struct Case {
    const char* name;
    Vec3 tip;
    std::array<Most, 2> most;
  };
  for (const Case& one : {Case{"side", {0.066, 0.10, 0.046}, {{{0.45, 0.001}, {0.26, 0.001}}}},
                          Case{"mouth", {0.02, 0.178, 0.02}, {{{0.62, 0.001}, {0.57, 0.02}}}}}) {
    view::Frame frame = show(kEdgedJar, edged_jar, 0.20, 0.09);
    sample(frame, std::string("without_finger_") + one.name);
    const std::vector<bool> edges = near_;
    frame.pot->hands[0] = {.present = true, .radius = 0.012, .at = one.tip};
    // The finger's own depth hides these edges.
    only_ = [&, at = *frame.pot->camera.project(one.tip)](int x, int y) {
      const double aside = x - static_cast<double>(at.first),
                   below = y - static_cast<double>(at.second);
      return edges[pixel(x, y)] && std::hypot(aside, below) < 40.0;
    };
    expect_smooth(frame, std::string("finger_") + one.name, one.most);
    // What edges would be like that a finger hid.
    const view::Image hidden = laid(frame, 0.5, nullptr, true);
    keep_for_looking(hidden, std::string("hidden_") + one.name);
    std::printf("%s: %.2f where a finger hides edges\n", one.name, difference(hidden));
    EXPECT_LT(difference(drawn(frame, 0.5)), 0.5 * difference(hidden)) << one.name;
    only_ = {};
  }
}

// Says the time too, for kiosk/docs/records/render.md.
TEST_F(AnEdge, CostsFewShaderRuns) {
  if (!calls::Shading::counted()) GTEST_SKIP() << "this driver counts no shader runs";
  view::Frame frame = show(kEdgedJar, edged_jar, 0.20, 0.09);
  frame = frame_with_pot(1920, 1080, 0.20, 0.09);
  frame.pot->wetness = 0.5;
  for (const int which : {0, 1, 2, 3}) {
    const double scale = which % 2 == 0 ? 0.5 : 0.25, open = which < 2 ? 0.0 : 1.0;
    frame.pot->cut_away = open;
    Canvas canvas;
    const Painters with{*stage_, *items_, {}};
    const auto paint = [&] {
      canvas.paint(with, frame, {.samples = 0}, scale, Canvas::Onto::own);
      glFinish();
    };
    paint();
    const auto runs_of = [](const auto& what) {
      const FrameWork before = calls::so_far();
      {
        const calls::Shading count(true);
        what();
      }
      return static_cast<double>((calls::so_far() - before).fragment_runs);
    };
    const Target space(static_cast<int>(1920 * scale), static_cast<int>(1080 * scale), true, 0),
        ground(1920, 1080, false, 0), onto(1920, 1080, false, 0);
    const auto edges = [&] {
      stage_->prepare_edges(*frame.pot, scale);
      onto.bind();
      stage_->draw_edges(*frame.pot, space, {}, ground.color(), 1920, 1080);
      glFinish();
    };
    // Of all threads, so that other work on the machine tells little.
    const auto ms_of = [](const auto& what) {
      double least = 1e9;
      for (int i = 0; i < 12; ++i) {
        const std::clock_t begun = std::clock();
        what();
        least = std::min(least, 1e3 * static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC);
      }
      return least;
    };
    space.bind();
    glDisable(GL_SCISSOR_TEST);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const double all = runs_of(paint), of_edges = runs_of(edges);
    std::printf("%s, scale %.2f: a frame %.0f fragments and %.2f ms, its edges %.0f and %.2f ms\n",
                open > 0.0 ? "open" : "closed", scale, all, ms_of(paint), of_edges, ms_of(edges));
    const double more = open > 0.0 ? 0.04 : 0.0;  // the section, at the frame's size
    EXPECT_LT(of_edges, (more + (scale > 0.4 ? 0.07 : 0.13)) * all) << scale << " " << open;
    EXPECT_GT(of_edges, 1000.0) << scale;
  }
}

}  // namespace
}  // namespace onggi::render::testing::edges_test
