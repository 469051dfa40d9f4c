#include "kiosk/visit/screens/wall_section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "kiosk/picture/render/text.h"
#include "tests/kiosk/visit/screens/decorator.h"
#include "tests/kiosk/visit/screens/layout_check.h"

namespace onggi::screens::wall_section_test {
namespace {

/// A visitor whose pot has a blue band round its middle, and goes into the kiln.
struct Banded : Decorator {
  explicit Banded(const view::TextMeasure* measure = nullptr) : Decorator("porcelain", measure) {}
  void fire(int glaze) {
    touch("result.keep");
    const auto [x, y] = middle();
    down(x, y);
    frames(1);
    up(x, y);
    frames(4);
    touch("decorate.on");
    touch("kiln.glaze." + std::to_string(glaze));
    frames(12);
  }
  /// The pixel of a row of the fired pot, which has shrunk, where it faces the eye.
  std::pair<float, float> at(int row) const {
    const surface::Row& of = pot()->surface().row(row);
    return *frame.pot->camera.project(
        {0, frame.pot->size * of.height, frame.pot->size * of.radius});
  }
  int band() const {
    const auto& surface = pot()->surface();
    int from = 0, to = 0;
    for (int j = 0; j < surface.rows(); ++j) {
      if (surface.slip(j, 0).word() == 0) continue;
      from = from == 0 ? j : from;
      to = j;
    }
    return (from + to) / 2;
  }
  void tap(std::pair<float, float> at) {
    down(at.first, at.second);
    show();
    up(at.first + 2, at.second);
    show();
  }
  bool says(const std::string& words) const {
    return words_in(frame).find(words) != std::string::npos;
  }
};

TEST(WallSection, ATapShowsWhatLiesOnTheClayThere) {
  Banded v;
  v.fire(1);
  EXPECT_FALSE(v.says("The wall at the mark"));
  v.tap(v.at(v.band()));
  ASSERT_TRUE(v.says("The wall at the mark"));
  const std::string glaze = v.glazes[1].name_in("en");
  EXPECT_TRUE(v.says("Cobalt blue: "));
  EXPECT_TRUE(v.says(glaze + ": "));
  EXPECT_TRUE(v.says("Clay"));
  v.tap(v.at(v.band() + 80));
  EXPECT_TRUE(v.says("The wall at the mark"));
  EXPECT_FALSE(v.says("Cobalt blue: ")) << "there is none so far from the band";
  for (const view::Item& item : v.frame.items) {
    const auto* box = std::get_if<view::Box>(&item);
    if (box == nullptr || box->fill.a == 0) continue;
    EXPECT_GT(box->fill.r + box->fill.g + box->fill.b, 0.1f) << "nothing on it is black";
  }
  // It is as thick as the fire has left it: half a coat.
  const decorating::Layers layers =
      v.pot()->layers_at({1e-6 * v.band() * surface::kRowHeight, 0.25});
  EXPECT_GT(layers.glaze, 5e-5);
  EXPECT_LT(layers.glaze, 4e-4);
  ASSERT_EQ(layers.slips.size(), 1u);
  EXPECT_GT(layers.slips[0].thickness, 1e-6);
}

TEST(WallSection, AGlazeHasTheColourThatItHasOnThePot) {
  content::GlazeLook brown;  // ochre glass on a brown body, without a slip of its own
  brown.body = {0.30f, 0.12f, 0.05f}, brown.glass = {0.55f, 0.30f, 0.10f}, brown.slip_cover = 0.0f;
  const content::LinearColor thin = seen_through(brown, brown.body, false, 5e-5),
                             full = seen_through(brown, brown.body, false, 5e-4);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_LT(thin[k], brown.body[k]);
    EXPECT_GT(thin[k], full[k]) << "a thin coat takes less light";
    EXPECT_NEAR(full[k], brown.body[k] * std::pow(brown.glass[k], 1.15f), 1e-5f) << "not the glass";
  }
  brown.slip_cover = 1.0f, brown.slip = {0.8f, 0.8f, 0.8f};
  EXPECT_GT(seen_through(brown, brown.body, false, 5e-4)[2], 5 * full[2]) << "its own slip";
  EXPECT_EQ(seen_through(brown, brown.body, true, 5e-4), full) << "not over another's";
}

TEST(WallSection, TheButtonShowsItTooAndTakesItAwayAndThePotStandsStill) {
  Banded v;
  v.fire(1);
  v.touch("kiln.section");
  v.frames(1);
  EXPECT_TRUE(v.says("The wall at the mark"));
  const double angle = v.frame.pot->clay_angle;
  v.frames(1);
  EXPECT_EQ(v.frame.pot->clay_angle, angle);
  v.touch("kiln.section");
  v.frames(1);
  EXPECT_FALSE(v.says("The wall at the mark"));
  EXPECT_NE(v.frame.pot->clay_angle, angle);
}

TEST(WallSection, AFingerThatDrawsTheLightAndATapBesideThePotShowNone) {
  Banded v;
  v.fire(1);
  const auto [x, y] = v.at(v.band());
  v.down(x, y);
  v.move(x + 90, y);
  v.move(x, y);
  v.up(x, y);
  v.show();
  EXPECT_FALSE(v.says("The wall at the mark"));
  v.tap({x + 320, y});
  EXPECT_FALSE(v.says("The wall at the mark"));
}

TEST(WallSection, ATouchThatSkipsTheFiringShowsNone) {
  Banded v;
  v.touch("result.keep");
  v.touch("decorate.mark");
  v.frames(4);
  v.touch("decorate.on");
  v.touch("kiln.glaze.1");
  v.tap({900, 300});
  EXPECT_FALSE(v.says("The wall at the mark"));
}

TEST(WallSection, APlainPotHasNone) {
  Banded v;
  v.touch("result.keep");
  v.touch("decorate.on");
  v.touch("kiln.glaze.1");
  v.frames(12);
  EXPECT_FALSE(v.visit->control("kiln.section"));
  v.tap({900, 300});
  EXPECT_FALSE(v.says("The wall at the mark"));
}

TEST(WallSection, NothingIsCutInAnyLanguageAtAnySize) {
  const render::Typesetter fonts;
  for (const auto& file : std::filesystem::directory_iterator("content/languages"))
    for (const auto& [width, height] : {std::pair{1080, 1920}, {1024, 600}}) {
      Banded v(&fonts);
      v.languages = {*content::Language::read(file)};
      v.width = width, v.height = height;
      v.show();
      v.fire(1);
      v.tap(v.at(v.band()));
      v.frames(1);
      check_layout(v, fonts, file.path().stem().string() + " " + std::to_string(width));
    }
}

}  // namespace
}  // namespace onggi::screens::wall_section_test
