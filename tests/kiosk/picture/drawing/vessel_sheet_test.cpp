#include "kiosk/picture/drawing/vessel_sheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kiosk/picture/drawing/engraving.h"
#include "kiosk/picture/drawing/sheet_painter.h"
#include "tests/engine/profile/poses.h"

// The archaeologist's drawing, which needs no display.

namespace onggi::drawing::vessel_sheet_test {
namespace {

content::Vessel jug() {
  content::Vessel vessel;
  vessel.id = "jug";
  vessel.file = "jug.glb";
  vessel.true_height = 0.30;
  TriangleMesh mesh = revolve(section_of(shapes::jar()), 96);
  mesh.normals.clear();
  shapes::add_handle(mesh, shapes::jar(), 0.08, 0.25, 0.05, 0.012);
  vessel.mesh = shapes::moved(mesh, {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}, {}});  // handle towards us
  vessel.extracted = *extract_profile(vessel.mesh, {}, "jug");
  return vessel;
}

struct Pixel {
  int r, g, b, a;
};
Pixel at(const view::Image& image, int x, int y) {
  const std::uint8_t* p =
      &image.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                       static_cast<std::size_t>(x))];
  return {p[0], p[1], p[2], p[3]};
}
bool clay_red(Pixel p) { return p.r - p.b > 45 && p.r > 120 && p.a > 200; }

TEST(Engraving, a_ball_is_as_large_as_it_is_and_lit_from_the_upper_left) {
  Section half;
  for (int i = 0; i <= 60; ++i) {
    const double a = portable::kPi * (i / 60.0 - 0.5);
    half.outline.push_back(
        {i == 0 || i == 60 ? 0.0 : 0.05 * portable::cos(a), 0.05 * portable::sin(a)});
  }
  const view::Image image = engrave(revolve(half, 96), {}, {-0.06, 0.06, -0.06, 0.06, 2000});
  ASSERT_EQ(image.width, 240);
  double covered = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) covered += at(image, x, y).a / 255.0;
  EXPECT_NEAR(covered, portable::kPi * 100 * 100, 0.01 * portable::kPi * 100 * 100);
  EXPECT_GT(at(image, 85, 85).g, at(image, 155, 155).g + 20);
}

// A moon jar's wall flares from its foot: what calipers take a few mm up is wider than its edge.
TEST(VesselSheet, foot_and_mouth_stand_where_they_were_measured) {
  const content::Vessel vessel = *content::load_vessel("content/vessels/moon_jar");
  const VesselSheet sheet = sheet_of(vessel);
  const Profile& p = vessel.extracted.profile;
  EXPECT_NEAR(2.0 * p.outer_at(sheet.foot_height), sheet.foot, 2e-4);
  EXPECT_NEAR(2.0 * p.outer_at(sheet.mouth_height), sheet.mouth, 2e-4);
  EXPECT_LT(sheet.foot_height, 0.02 * sheet.height);
  EXPECT_GT(sheet.mouth_height, 0.98 * sheet.height);
}

TEST(VesselSheet, the_handle_is_turned_to_the_right_and_tinted_as_left_out) {
  const VesselSheet sheet = sheet_of(jug());
  float right = 0, left = 0;
  for (const auto& p : sheet.mesh.positions) {
    right = std::max(right, p[0]);
    left = std::min(left, p[0]);
  }
  EXPECT_GT(right, -left + 0.03f);
  for (const auto& piece : sheet.slice) EXPECT_LT(std::min(piece[0].x, piece[1].x), 0.0);
  EXPECT_GT(sheet.slice.size(), 100u);
  const view::Image image = draw_sheet(sheet);
  EXPECT_EQ(image.width, 2400);
  int red_right = 0, red_left = 0;
  for (int y = 300; y < 2000; y += 3)
    for (int x = 0; x < image.width; x += 3)
      if (clay_red(at(image, x, y))) ++(x > 1200 ? red_right : red_left);
  EXPECT_GT(red_right, 1000);
  // On the left only the hairline of the mesh is red.
  EXPECT_LT(red_left, red_right);
}

TEST(VesselSheet, a_wall_that_was_not_seen_is_drawn_as_inferred_and_one_that_was_is_not) {
  content::Vessel seen = jug();
  EXPECT_TRUE(sheet_of(seen).inner_inferred.empty());
  Profile solid = shapes::jar();
  for (ProfilePoint& p : solid.points) p.inner = 0.0;
  content::Vessel bare;
  bare.id = "jar";
  bare.file = "jar.glb";
  bare.size_from = content::SizeFrom::guess;
  bare.mesh = revolve(section_of(solid), 64);
  bare.extracted = *extract_profile(bare.mesh, {}, "jar");
  const VesselSheet sheet = sheet_of(bare);
  EXPECT_TRUE(sheet.inner_seen.empty());
  EXPECT_FALSE(sheet.inner_inferred.empty());
  EXPECT_FALSE(sheet.true_size);
}

TEST(VesselSheet, a_dish_and_a_bottle_both_fit_the_paper) {
  for (const Profile& p : {shapes::bottle(), shapes::bowl(), scaled(shapes::bowl(), 0.01),
                           shapes::vessel(
                               2.0, [](double t) { return 0.05 + 0.01 * t; }, 0.01, 0.02),
                           shapes::vessel(
                               0.02, [](double t) { return 0.2 + 0.05 * t; }, 0.005, 0.004)}) {
    content::Vessel vessel;
    vessel.file = "a.glb";
    vessel.mesh = revolve(section_of(p), 64);
    auto found = extract_profile(vessel.mesh, {}, "a");
    ASSERT_TRUE(found) << to_text(found.error());
    vessel.extracted = std::move(*found);
    const view::Image image = draw_sheet(sheet_of(vessel));
    EXPECT_LT(image.height, 3600);
    // A margin of paper all round.
    for (int x = 0; x < image.width; x += 7)
      for (const int y : {3, 40, image.height - 40, image.height - 3})
        EXPECT_GT(at(image, x, y).r, 240) << x << " " << y;
    for (int y = 0; y < image.height; y += 7)
      for (const int x : {3, 40, image.width - 40, image.width - 3})
        EXPECT_GT(at(image, x, y).r, 240) << x << " " << y;
  }
}

TEST(VesselSheet, no_number_of_notes_makes_it_taller_than_a_page) {
  VesselSheet sheet = sheet_of(jug());
  const int usual = draw_sheet(sheet).height;
  std::string long_words;
  for (int i = 0; i < 400; ++i) long_words += "word ";
  sheet.title = sheet.subtitle = sheet.credit = long_words;
  sheet.notes.assign(300, "The bounds declared for an accessor are not three numbers each.");
  sheet.notes[1] = long_words;
  const view::Image image = draw_sheet(sheet);
  EXPECT_GE(image.height, usual);
  EXPECT_LE(image.height, 3394);  // 2400 times the square root of 2
  // Nothing runs over the lower edge or into the credit's place from the notes above it.
  for (int x = 0; x < image.width; x += 3) EXPECT_GT(at(image, x, image.height - 8).r, 240) << x;
  int inked = 0;
  for (int y = image.height - 150; y < image.height - 112; ++y)
    for (int x = 1400; x < image.width - 130; ++x) inked += at(image, x, y).r < 200 ? 1 : 0;
  EXPECT_EQ(inked, 0);
}

}  // namespace
}  // namespace onggi::drawing::vessel_sheet_test
