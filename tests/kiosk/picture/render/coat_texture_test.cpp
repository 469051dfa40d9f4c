#include "kiosk/picture/render/coat_texture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/clay/lip.h"
#include "kiosk/collection/content/glaze.h"
#include "kiosk/collection/decoration/decorate.h"
#include "tests/kiosk/picture/render/decorated_jar.h"

namespace onggi::render::testing::coat_texture_test {
namespace {

constexpr double kTall = 0.18;
constexpr int kFrameSide = 700;

view::Frame frame_of(view::Finish finish) {
  view::Frame frame = frame_with_pot(kFrameSide, kFrameSide, kTall, 0.066);
  frame.pot->wheel = false;
  frame.pot->finish = finish;
  return frame;
}

content::GlazeLook look_of(const std::string& id) {
  const auto all = content::read_glazes("content/glazes.toml").glazes;
  const auto found = std::ranges::find(all, id, &content::Glaze::id);
  return found == all.end() ? content::GlazeLook{} : found->look;
}

class Decorated : public StudioTest {
 protected:
  void TearDown() override {
    if (!IsSkipped()) renderer().show_decoration(nullptr);
  }
  static view::Image show(DecoratedJar& pot, const view::Frame& frame, bool fired) {
    renderer().show_clay(pot.clay);
    renderer().show_decoration(pot.draw(fired));
    return renderer().draw_offscreen(frame);
  }
  static view::Image bare(DecoratedJar& pot, const view::Frame& frame) {
    renderer().show_clay(pot.clay);
    renderer().show_decoration(nullptr);
    return renderer().draw_offscreen(frame);
  }
  /// Of the outer wall at a share of the height, `turns` round the clay.
  static Pixel seen(const view::Image& image, const view::Frame& frame, const DecoratedJar& pot,
                    double share, double turns) {
    const double y = share * pot.profile.height(), r = pot.profile.outer_at(y);
    const double angle = 2.0 * std::numbers::pi * turns + frame.pot->clay_angle;
    const auto at = frame.pot->camera.project({r * std::cos(angle), y, r * std::sin(angle)});
    return pixel_at(image, static_cast<int>(at->first), static_cast<int>(at->second));
  }
};

constexpr double kFront = 0.25;  // of a turn, where the camera stands

TEST_F(Decorated, ABandIsWhiteAtItsHeightAndClayElsewhere) {
  DecoratedJar pot(kTall, 0.0);
  pot.lay(pot.ring(brush_of(0, 0.008), 0.5));
  const view::Frame frame = frame_of(view::Finish::clay);
  const view::Image with = show(pot, frame, false), without = bare(pot, frame);
  for (const double share : {0.15, 0.3, 0.45, 0.55, 0.7, 0.9}) {
    const Pixel a = seen(with, frame, pot, share, kFront),
                b = seen(without, frame, pot, share, kFront);
    EXPECT_NEAR(a.r, b.r, 1) << share;
    EXPECT_NEAR(a.b, b.b, 1) << share;
  }
  const Pixel band = seen(with, frame, pot, 0.5, kFront);
  const Pixel clay = seen(without, frame, pot, 0.5, kFront);
  EXPECT_GT(band.b, clay.b + 60);
  EXPECT_LT(band.r - band.b, 30) << "white, where clay is brown";
  // Its edges, 4 mm away.
  for (const int side : {-1, 1}) {
    EXPECT_GT(seen(with, frame, pot, 0.5 + side * 0.0033 / kTall, kFront).b, clay.b + 50);
    EXPECT_LT(seen(with, frame, pot, 0.5 + side * 0.0050 / kTall, kFront).b, clay.b + 10);
  }
}

TEST_F(Decorated, SlipThatWasJustLaidGlistensAndTheClayBesideItDoesNot) {
  DecoratedJar pot(kTall, 0.0);
  // Dark, and where the window's light is reflected to the eye.
  for (const double share : {0.6, 0.7, 0.8}) pot.lay(pot.ring(brush_of(1, 0.03), share));
  view::Frame frame = frame_of(view::Finish::clay);
  const view::Image dry = show(pot, frame, false);
  frame.pot->slip_wet = true;
  frame.pot->wetness_by_row.assign(96, 1.0f);
  const view::Image wet = show(pot, frame, false);
  keep_for_looking(dry, "dry_slip");
  keep_for_looking(wet, "wet_slip");
  int most = 0;
  for (double turns = kFront - 0.22; turns < kFront + 0.22; turns += 0.002) {
    for (double share = 0.58; share < 0.82; share += 0.01)
      most = std::max(
          most, seen(wet, frame, pot, share, turns).r - seen(dry, frame, pot, share, turns).r);
    for (const double beside : {0.2, 0.4})
      EXPECT_NEAR(seen(wet, frame, pot, beside, turns).r, seen(dry, frame, pot, beside, turns).r, 1)
          << turns;
  }
  EXPECT_GT(most, 60);
}

TEST_F(Decorated, StripesThatArePackedAtTheSideAreGreyThereAndNotDots) {
  DecoratedJar pot(kTall, 0.0);
  constexpr int kStripes = 240;
  for (int n = 0; n < kStripes / 12; ++n)
    pot.lay(pot.way(brush_of(0, 0.0009),
                    {{pot.along(0.35), 1.0 * n / kStripes}, {pot.along(0.65), 1.0 * n / kStripes}}),
            12);
  const view::Frame frame = frame_of(view::Finish::clay);
  const view::Image with = show(pot, frame, false), without = bare(pot, frame);
  // Where a stripe and its gap together are less than a pixel wide.
  double mean = 0.0, square = 0.0;
  int places = 0;
  for (double share = 0.45; share < 0.55; share += 0.01)
    for (double turns = kFront + 0.214; turns < kFront + 0.225; turns += 0.001) {
      const double whiter =
          seen(with, frame, pot, share, turns).b - seen(without, frame, pot, share, turns).b;
      mean += whiter, square += whiter * whiter, ++places;
    }
  mean /= places;
  EXPECT_GT(mean, 15.0);
  EXPECT_LT(std::sqrt(square / places - mean * mean), 0.25 * mean);
}

TEST_F(Decorated, WhatIsPaintedTurnsWithTheClay) {
  DecoratedJar pot(kTall, 0.0);
  pot.lay(pot.area(0, 0.5, 0.1, {{-5, -5}, {-5, 5}, {5, 5}, {5, -5}}));
  for (const double turns : {0.1, 0.15, 0.17}) {
    view::Frame frame = frame_of(view::Finish::clay);
    frame.pot->clay_angle = 2.0 * std::numbers::pi * turns;
    const view::Image with = show(pot, frame, false), without = bare(pot, frame);
    EXPECT_GT(seen(with, frame, pot, 0.5, 0.1).b, seen(without, frame, pot, 0.5, 0.1).b + 60)
        << turns;
    for (const double beside : {0.07, 0.13})
      EXPECT_NEAR(seen(with, frame, pot, 0.5, beside).b, seen(without, frame, pot, 0.5, beside).b,
                  1);
  }
}

// Where the table's first and last sectors meet, and from the wall over the lip into the pot.
TEST_F(Decorated, NoSeamIsSeenWhereThePictureBeginsNorAtTheLip) {
  DecoratedJar pot(kTall, 0.0);
  surface::DipDef dip;
  dip.coat = 1, dip.from = 0.0, dip.to = 2.0;
  pot.lay(dip);
  view::Frame frame = frame_of(view::Finish::clay);
  frame.pot->clay_angle = 0.5 * std::numbers::pi;
  const view::Image with = show(pot, frame, false);
  for (double turn = -0.05; turn < 0.05; turn += 0.002)
    EXPECT_LT(seen(with, frame, pot, 0.5, turn).r, 120) << turn;
  frame.pot->camera.target = {0, kTall, 0};
  frame.pot->camera.elevation = 1.1;
  const view::Image above = show(pot, frame, false), clay = bare(pot, frame);
  // From outside to the middle, all that is clay is dark.
  const auto middle = *frame.pot->camera.project({0, kTall, 0});
  int seen_clay = 0;
  for (int y = static_cast<int>(middle.second); y < kFrameSide - 20; ++y) {
    const Pixel a = pixel_at(above, static_cast<int>(middle.first), y),
                b = pixel_at(clay, static_cast<int>(middle.first), y);
    if (b.r - b.b < 25) continue;  // the floor's shade, or the table
    ++seen_clay;
    EXPECT_LT(a.r, b.r - 10) << y;
  }
  EXPECT_GT(seen_clay, 100);
}

TEST_F(Decorated, ALineOnTheLipsMiddleIsOnItsCrown) {
  DecoratedJar pot(kTall, 0.0);
  const double middle = 1e-6 * decoration::lip_of(pot.surface);
  pot.lay(pot.way(brush_of(0, 0.002), {{middle, 0.0}, {middle, 1.0}}));
  view::Frame frame = frame_of(view::Finish::clay);
  frame.pot->camera.target = {0, kTall, 0};
  frame.pot->camera.elevation = 1.1;
  frame.pot->camera.distance = 0.4;
  const view::Image with = show(pot, frame, false), without = bare(pot, frame);
  // The lip stands straight on its shoulders, also of a wall that leans.
  const double shoulder = kTall - kLipRadius, inner = pot.profile.inner_at(shoulder);
  const double wall = pot.profile.outer_at(shoulder) - inner;
  const auto paler = [&](double across) {
    const auto at = *frame.pot->camera.project({0, kTall, inner + across * wall});
    const auto x = static_cast<int>(at.first), y = static_cast<int>(at.second);
    return pixel_at(with, x, y).b - pixel_at(without, x, y).b;
  };
  EXPECT_GT(paler(0.5), 60);
  EXPECT_LT(paler(0.15), 3);
  EXPECT_LT(paler(0.85), 3);
}

TEST_F(Decorated, ABareDecorationIsNoDifference) {
  DecoratedJar pot;
  for (const view::Finish finish : {view::Finish::clay, view::Finish::firing, view::Finish::fired})
    for (const double wet : {0.0, 0.6}) {
      view::Frame frame = frame_of(finish);
      frame.pot->wetness = wet;
      frame.pot->firing.done = 0.5;
      const view::Image with = show(pot, frame, false), without = bare(pot, frame);
      int most = 0;
      for (std::size_t i = 0; i < with.rgba.size(); ++i)
        most = std::max(most, std::abs(with.rgba[i] - without.rgba[i]));
      EXPECT_LE(most, 1) << static_cast<int>(finish) << ' ' << wet;
      if (finish != view::Finish::clay) break;
    }
}

TEST_F(Decorated, ACutIsDarkerUnderCeladon) {
  DecoratedJar pot(kTall, 0.0);
  surface::CutDef cut;
  cut.width = 0.0016, cut.depth = 0.0006, cut.section = surface::CutDef::flat;
  pot.lay(pot.ring(cut, 0.6));
  view::Frame frame = frame_of(view::Finish::fired);
  frame.pot->glazing.look = look_of("celadon");
  frame.pot->glazing.look.gloss = 0;
  const view::Image with = show(pot, frame, true), without = bare(pot, frame);
  const Pixel in = seen(with, frame, pot, 0.6, kFront),
              was = seen(without, frame, pot, 0.6, kFront);
  EXPECT_LT(in.r, was.r - 35);
  EXPECT_LT(in.r - was.r, in.g - was.g - 5) << "green, by more glass";
  EXPECT_NEAR(seen(with, frame, pot, 0.64, kFront).g, seen(without, frame, pot, 0.64, kFront).g, 2);
}

TEST_F(Decorated, WhiteSlipIsPalerThanItsGroundUnderCeladonAndTheGlazesOwnBandIsLeftOut) {
  DecoratedJar pot(kTall, 0.0);
  pot.lay(pot.ring(brush_of(0, 0.008), 0.6));
  view::Frame frame = frame_of(view::Finish::fired);
  frame.pot->glazing.look = look_of("celadon");
  const view::Image with = show(pot, frame, true), without = bare(pot, frame);
  const Pixel slip = seen(with, frame, pot, 0.6, kFront),
              was = seen(without, frame, pot, 0.6, kFront);
  EXPECT_GT(slip.r, was.r + 15);
  frame.pot->glazing.look = look_of("clear");
  const Pixel clear = seen(show(pot, frame, true), frame, pot, 0.6, kFront);
  EXPECT_GT(slip.g * clear.r, slip.r * clear.g) << "greener than through clear glass";
  frame.pot->glazing.look = look_of("white_porcelain");
  frame.pot->glazing.look.gloss = 0;
  frame.pot->glazing.look.band_height = 0.84f;
  frame.pot->glazing.look.band_width = 0.014f;
  const double at = static_cast<double>(frame.pot->glazing.look.band_height);
  const view::Image plain = bare(pot, frame), painted = show(pot, frame, true);
  const auto bluest = [&](const view::Image& image) {
    int most = -255;
    for (int n = -20; n <= 20; ++n) {
      const Pixel p = seen(image, frame, pot, at + 2e-4 * n / kTall, kFront);
      most = std::max(most, p.b - p.r);
    }
    return most;
  };
  EXPECT_GT(bluest(plain), 20);
  EXPECT_LT(bluest(painted), 10);
}

TEST_F(Decorated, WipedGlazeShowsTheBodyBetweenDarkerRidges) {
  DecoratedJar pot(kTall, 0.0);
  surface::DipDef dip;
  dip.from = 0.0, dip.to = 2.0, dip.seconds = 1.0;
  pot.lay(dip);
  view::Frame frame = frame_of(view::Finish::fired);
  frame.pot->glazing.look = look_of("onggi");
  frame.pot->glazing.look.gloss = 0;
  const view::Image even = show(pot, frame, true);
  surface::WipeDef wipe;
  wipe.width = 0.012;
  pot.lay(pot.ring(wipe, 0.5));
  const view::Image with = show(pot, frame, true);
  const Pixel in = seen(with, frame, pot, 0.5, kFront), was = seen(even, frame, pot, 0.5, kFront);
  EXPECT_GT(in.r, was.r + 15) << "the body";
  for (const int side : {-1, 1}) {
    int darkest = 255;
    for (int mm = 60; mm < 100; ++mm)
      darkest = std::min(darkest, seen(with, frame, pot, 0.5 + side * mm * 1e-4 / kTall, kFront).r);
    EXPECT_LT(darkest, was.r - 8) << "a ridge beside it";
  }
}

TEST_F(Decorated, APolishedPlaceShinesAndPaintIsMattOnDryClay) {
  DecoratedJar pot(kTall, 0.0);
  surface::BurnishDef stone;
  stone.width = 0.006;
  for (int pass = 0; pass < 3; ++pass) pot.lay(pot.ring(stone, 0.6));
  renderer().show_clay(pot.clay);
  renderer().show_decoration(pot.draw(false));
  const ClayMesh mesh = faced_mesh_of(pot.clay);
  const auto skin = renderer().read_skin(mesh, std::nullopt);
  double polished = 1, rough = 0;
  for (std::size_t i = 0; i < skin.size(); ++i) {
    const double share = static_cast<double>(mesh.mesh.positions[i][1]) / kTall;
    if (mesh.faces[i] != ClayFace::outer) continue;
    if (std::abs(share - 0.6) < 0.005)
      polished = std::min(polished, static_cast<double>(skin[i].roughness));
    if (share < 0.5) rough = std::max(rough, static_cast<double>(skin[i].roughness));
  }
  EXPECT_NEAR(polished, 0.28, 0.02);
  EXPECT_NEAR(rough, 0.78, 0.01);
}

TEST_F(Decorated, TheSurfaceIsReadOffWithItsPaint) {
  DecoratedJar pot(kTall, 0.0);
  pot.lay(pot.ring(brush_of(0, 0.02), 0.6));
  renderer().show_clay(pot.clay);
  renderer().show_decoration(pot.draw(false));
  const ClayMesh mesh = faced_mesh_of(pot.clay);
  int painted = 0;
  const auto skin = renderer().read_skin(mesh, std::nullopt);
  for (std::size_t i = 0; i < skin.size(); ++i) {
    const double away = std::abs(static_cast<double>(mesh.mesh.positions[i][1]) - 0.6 * kTall);
    if (mesh.faces[i] != ClayFace::outer) continue;
    if (away < 0.007) {
      ++painted;
      EXPECT_NEAR(skin[i].color[2], 0.57f, 0.06f);
    } else if (away > 0.013) {
      EXPECT_LT(skin[i].color[2], 0.2f);
    }
  }
  EXPECT_GT(painted, 1000);
}

/// Where the pot begins in a line of the picture, from the left, pixels.
int left_edge(const view::Image& image, int line) {
  for (int x = 1; x < image.width; ++x)
    if (std::abs(pixel_at(image, x, line).r - pixel_at(image, x - 1, line).r) > 12) return x;
  return image.width;
}

TEST_F(Decorated, ACoilMovesTheOutlineByItsHeightAndOnlyThere) {
  DecoratedJar pot(kTall, 0.0);
  const view::Frame frame = frame_of(view::Finish::clay);
  const view::Image plain = bare(pot, frame);
  pot.lay(pot.ring(surface::CoilDef{.width = 0.01, .height = 0.003, .press = 0.0}, 0.5));
  const view::Image with = show(pot, frame, false);
  keep_for_looking(with, "coil");
  const view::Camera& camera = frame.pot->camera;
  const Vec3 eye = camera.eye();
  const auto side = [&](double r, double y) {
    const double away = std::hypot(eye.x, eye.z), turned = std::acos(r / away),
                 angle = std::atan2(eye.z, eye.x) + turned;
    return *camera.project({r * std::cos(angle), y, r * std::sin(angle)});
  };
  const auto line = [&](double share) {
    const double y = share * kTall;
    return static_cast<int>(side(pot.profile.outer_at(y), y).second);
  };
  const double y = 0.5 * kTall, r = pot.profile.outer_at(y);
  const double wanted = side(r, y).first - side(r + 0.003, y).first;
  ASSERT_GT(wanted, 5.0);
  EXPECT_NEAR(left_edge(plain, line(0.5)) - left_edge(with, line(0.5)), wanted, 1.5);
  for (const double share : {0.2, 0.4, 0.6, 0.8})
    EXPECT_NEAR(left_edge(plain, line(share)), left_edge(with, line(share)), 1) << share;
}

TEST_F(Decorated, AnUndecoratedPotAfterADecoratedOneHasItsVeryBytes) {
  DecoratedJar pot;
  pot.lay(pot.ring(brush_of(0, 0.02), 0.6));
  for (const view::Finish finish : {view::Finish::clay, view::Finish::fired}) {
    const view::Frame frame = frame_of(finish);
    const view::Image before = bare(pot, frame), with = show(pot, frame, false);
    EXPECT_NE(with.rgba, before.rgba);
    EXPECT_EQ(bare(pot, frame).rgba, before.rgba);
  }
}

// What a tile has in both textures, with their reduced levels.
constexpr std::uint64_t kTileBytes = 2 * 4 * (64 * 60 + 32 * 30 + 16 * 15);

TEST_F(Decorated, OnlyTilesThatHaveChangedAreUploaded) {
  DecoratedJar pot;
  CoatTexture coat;
  const auto sent = [&] {
    const FrameWork before = calls::so_far();
    coat.show(&pot.picture);
    return (calls::so_far() - before).bytes;
  };
  const auto tiles =
      static_cast<std::uint64_t>(pot.picture.tiles_down() * pot.picture.tiles_across());
  EXPECT_EQ(sent(), tiles * kTileBytes + 512 * 2 * 4 + 1) << "all of it, the table, and no bead";
  EXPECT_EQ(sent(), 0u);
  pot.picture.touch(70, 80, 70, 80);
  pot.picture.touch(70, 80, 190, 200);
  pot.picture.draw(pot.surface, 100);
  EXPECT_EQ(sent(), 2 * kTileBytes);
  const std::uint64_t number = coat.change();
  coat.show(nullptr);
  EXPECT_FALSE(coat.shown());
  EXPECT_EQ(coat.change(), 0u);
  EXPECT_EQ(sent(), 0u) << "it is still there";
  EXPECT_EQ(coat.change(), number);
  DecoratedJar other;
  coat.show(&other.picture);
  EXPECT_NE(coat.change(), number);
}

TEST_F(Decorated, AStrokeIsSeenInTheNextFrame) {
  DecoratedJar pot;
  const view::Frame frame = frame_of(view::Finish::clay);
  renderer().show_clay(pot.clay);
  renderer().show_decoration(pot.draw(false));
  for (int n = 0; n < 3; ++n) renderer().draw(frame);
  const view::Image before = renderer().read_pixels();
  pot.lay(pot.ring(brush_of(0, 0.02), 0.6));
  renderer().show_decoration(pot.draw(false));
  renderer().draw(frame);
  EXPECT_NE(renderer().read_pixels().rgba, before.rgba);
}

}  // namespace
}  // namespace onggi::render::testing::coat_texture_test
