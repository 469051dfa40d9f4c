#include <algorithm>
#include <array>
#include <cmath>

#include "kiosk/picture/view/palette.h"
#include "tests/kiosk/picture/render/studio_fixture.h"

namespace onggi::render::testing::frame_test {
namespace {

using AFrame = StudioTest;

double cylinder(double) { return 0.05; }
const ClayDef kCylinder = grid_of(200, 180, 0.15, 0.010);

view::Frame empty_frame() {
  view::Frame frame;
  frame.width = 640;
  frame.height = 400;
  return frame;
}

view::Image drawn(Renderer& r, const view::Frame& frame) {
  r.draw(frame);
  return r.read_pixels();
}

int difference(Pixel a, Pixel b) {
  return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
}

TEST_F(AFrame, WithNothingInItIsPlaster) {
  const view::Image image = drawn(renderer(), empty_frame());
  ASSERT_EQ(image.width, 640);
  for (int y = 5; y < 400; y += 39) {
    for (int x = 5; x < 640; x += 63) {
      const Pixel p = pixel_at(image, x, y);
      EXPECT_LT(difference(p, {0xED, 0xE8, 0xE1}), 45);
      EXPECT_GE(p.r, p.g);
      EXPECT_GE(p.g, p.b);  // warm white all over
    }
  }
}

TEST_F(AFrame, PlasterNeverBandsIntoFlatSteps) {
  // A banded gradient has long runs of one value in a row; a dithered one does not.
  const view::Image image = drawn(renderer(), empty_frame());
  int run = 0, longest = 0;
  for (int x = 1; x < 640; ++x) {
    run = difference(pixel_at(image, x, 390), pixel_at(image, x - 1, 390)) == 0 ? run + 1 : 0;
    longest = std::max(longest, run);
  }
  EXPECT_LT(longest, 40);
}

TEST_F(AFrame, BoxesStandWhereTheyWerePutAndInTheirColour) {
  view::Frame frame = empty_frame();
  frame.items.emplace_back(view::Box{{100, 50, 200, 80}, 0, view::kCobalt, 0, {}});
  frame.items.emplace_back(view::Box{{100, 200, 200, 80}, 30, view::kIron, 0, {}});
  const view::Image image = drawn(renderer(), frame);
  EXPECT_LT(difference(pixel_at(image, 100, 50), {0x2F, 0x4B, 0x7C}), 4);
  EXPECT_LT(difference(pixel_at(image, 299, 129), {0x2F, 0x4B, 0x7C}), 4);
  EXPECT_GT(difference(pixel_at(image, 98, 50), {0x2F, 0x4B, 0x7C}), 200);
  EXPECT_LT(difference(pixel_at(image, 200, 240), {0x8A, 0x3B, 0x22}), 4);
  EXPECT_GT(difference(pixel_at(image, 101, 201), {0x8A, 0x3B, 0x22}), 200);  // round corner
}

TEST_F(AFrame, LinesAreAsWideAsAsked) {
  view::Frame frame = empty_frame();
  view::Line line;
  line.points = {{100, 100}, {500, 100}};
  line.colors = {view::kInk};
  line.width = 6;
  frame.items.emplace_back(line);
  const view::Image image = drawn(renderer(), frame);
  double ink = 0;
  for (int y = 80; y < 120; ++y) ink += (237 - pixel_at(image, 300, y).r) / (237.0 - 35.0);
  EXPECT_NEAR(ink, 6.0, 0.4);
}

TEST_F(AFrame, PicturesKeepTheirAspectAndTheirSidesUp) {
  view::Image flag{2, 4, std::vector<std::uint8_t>(32, 255)};
  for (std::size_t i = 0; i < 16; i += 4) flag.rgba[i + 1] = flag.rgba[i + 2] = 0;  // top half red
  const view::PictureId id = renderer().make_picture(flag);
  view::Frame frame = empty_frame();
  frame.items.emplace_back(view::Picture{{100, 100, 200, 100}, id, 1});
  const view::Image image = drawn(renderer(), frame);
  EXPECT_LT(difference(pixel_at(image, 200, 110), {255, 0, 0}), 10);
  EXPECT_LT(difference(pixel_at(image, 200, 190), {255, 255, 255}), 10);
  EXPECT_LT(difference(pixel_at(image, 150, 150), {0xED, 0xE8, 0xE1}), 45);  // outside its 50 px
  renderer().drop_picture(id);
  EXPECT_LT(difference(pixel_at(drawn(renderer(), frame), 200, 110), {0xED, 0xE8, 0xE1}), 45);
}

TEST_F(AFrame, AFadeShowsThePictureOfTheScreenBefore) {
  Renderer& r = renderer();
  view::Frame before = empty_frame();
  before.screen_serial = 101;
  before.items.emplace_back(view::Box{{0, 0, 640, 400}, 0, {1, 0, 0, 1}, 0, {}});
  r.draw(before);
  view::Frame after = empty_frame();
  after.screen_serial = 102;
  after.items.emplace_back(view::Box{{0, 0, 640, 400}, 0, {0, 0, 1, 1}, 0, {}});
  after.fade = 0.75f;
  const Pixel early = pixel_at(drawn(r, after), 320, 200);
  EXPECT_NEAR(early.r, 191, 3);
  EXPECT_NEAR(early.b, 64, 3);
  after.fade = 0.25f;
  EXPECT_NEAR(pixel_at(drawn(r, after), 320, 200).r, 64, 3);
  after.fade = 0;
  EXPECT_EQ(pixel_at(drawn(r, after), 320, 200).r, 0);
}

TEST_F(AFrame, TheClayStandsWhereTheCameraSaysItDoes) {
  Renderer& r = renderer();
  r.show_clay(thrown_clay(kCylinder, cylinder, 0.008, 0));
  view::Frame frame = frame_with_pot(800, 600, 0.15, 0.05);
  const view::Image with = drawn(r, frame);
  for (const double side : {-1.0, 1.0}) {
    const auto inside = frame.pot->camera.project({side * 0.045, 0.12, 0});
    const auto outside = frame.pot->camera.project({side * 0.056, 0.12, 0});
    const Pixel in =
        pixel_at(with, static_cast<int>(inside->first), static_cast<int>(inside->second));
    const Pixel out =
        pixel_at(with, static_cast<int>(outside->first), static_cast<int>(outside->second));
    EXPECT_GT(in.r - in.b, 25) << "clay is brown";
    EXPECT_LT(out.r - out.b, 25) << "plaster is not";
  }
}

TEST_F(AFrame, WetClayIsDarkerThanDryClay) {
  Renderer& r = renderer();
  r.show_clay(thrown_clay(kCylinder, cylinder, 0.008, 0));
  view::Frame frame = frame_with_pot(800, 600, 0.15, 0.05);
  const auto at = frame.pot->camera.project({0.01, 0.07, 0.049});
  const int x = static_cast<int>(at->first), y = static_cast<int>(at->second);
  const Pixel dry = pixel_at(drawn(r, frame), x, y);
  frame.pot->wetness = 1;
  const Pixel wet = pixel_at(drawn(r, frame), x, y);
  EXPECT_GT(dry.r + dry.g + dry.b, wet.r + wet.g + wet.b + 60);
}

TEST_F(AFrame, ChangedRowsShowAndOthersStay) {
  Renderer& r = renderer();
  ClayView clay = thrown_clay(kCylinder, cylinder, 0.008, 0);
  r.show_clay(clay);
  view::Frame frame = frame_with_pot(800, 600, 0.15, 0.05);
  const view::Image before = drawn(r, frame);
  for (int j = 100; j < 120; ++j)  // a bulge at half height
    clay.shape(j, std::vector<float>(180, 0.060f), std::vector<float>(180, 0.042f));
  r.update_clay(clay);
  const view::Image after = drawn(r, frame);
  const auto bulge = frame.pot->camera.project({0.057, 0.0825, 0});
  const auto below = frame.pot->camera.project({0.045, 0.03, 0});
  const auto at = [](const view::Image& image, const auto& p) {
    return pixel_at(image, static_cast<int>(p->first), static_cast<int>(p->second));
  };
  EXPECT_GT(difference(at(before, bulge), at(after, bulge)), 40);
  EXPECT_LT(difference(at(before, below), at(after, below)), 25);
}

TEST_F(AFrame, RowsPressedTogetherAreDrawnWhereTheyStand) {
  // One outline on even rows, and on rows of which the upper half is half as thick.
  const auto outline = [](double h) { return 0.045 + 0.01 * std::sin(60 * h); };
  const auto clay_of = [&](const ClayDef& grid, const auto& middle) {
    ClayView clay;
    clay.lay(grid);
    for (int j = 0; j < grid.rows; ++j) {
      const auto radius = static_cast<float>(outline(middle(j)));
      const bool solid = middle(j) < 0.010;
      clay.place(j, {middle(j), 0.1125, 0.010, solid ? j + 1 : 0, false});
      clay.shape(j, std::vector<float>(180, radius),
                 std::vector<float>(180, solid ? 0.0f : radius - 0.008f));
    }
    return clay;
  };
  Renderer& r = renderer();
  view::Frame frame = frame_with_pot(800, 600, 0.1125, 0.055);
  frame.pot->cut_away = 1;
  const ClayDef even = grid_of(150, 180, 0.1125, 0.010);
  r.show_clay(clay_of(even, [](int j) { return (j + 0.5) * 0.00075; }));
  const view::Image expected = drawn(r, frame);
  r.show_clay(clay_of(kCylinder, [](int j) {
    return j < 100 ? (j + 0.5) * 0.00075 : 0.075 + (j - 99.5) * 0.000375;
  }));
  const view::Image image = drawn(r, frame);
  int unlike = 0;
  for (int y = 0; y < 600; ++y)
    for (int x = 0; x < 800; ++x)
      unlike += difference(pixel_at(image, x, y), pixel_at(expected, x, y)) > 24;
  EXPECT_LT(unlike, 500) << "of 480,000 pixels";
}

TEST_F(AFrame, AnOpenedPotShowsItsSectionAtTheRight) {
  Renderer& r = renderer();
  r.show_clay(thrown_clay(kCylinder, cylinder, 0.012, 0));
  view::Frame frame = frame_with_pot(800, 600, 0.15, 0.05);
  const view::Image closed = drawn(r, frame);
  frame.pot->cut_away = 1;
  const view::Image open = drawn(r, frame);
  const auto wall = frame.pot->camera.project({0.044, 0.07, 0});
  const auto left = frame.pot->camera.project({-0.03, 0.07, 0.039});
  const auto at = [](const view::Image& image, const auto& p) {
    return pixel_at(image, static_cast<int>(p->first), static_cast<int>(p->second));
  };
  EXPECT_GT(at(open, wall).r, at(closed, wall).r + 20) << "the section is pale";
  EXPECT_LT(difference(at(open, left), at(closed, left)), 6) << "the left stays shut";
}

TEST_F(AFrame, TheInsideOfADeepJarIsDark) {
  Renderer& r = renderer();
  r.show_clay(thrown_clay(
      kCylinder, [](double) { return 0.03; }, 0.005, 0));
  view::Frame frame = frame_with_pot(800, 600, 0.15, 0.05);
  frame.pot->camera.elevation = 1.25;
  const view::Image image = drawn(r, frame);
  const auto deep = frame.pot->camera.project({0, 0.03, -0.022});
  const auto lip = frame.pot->camera.project({-0.0275, 0.1505, 0});
  const Pixel d = pixel_at(image, static_cast<int>(deep->first), static_cast<int>(deep->second));
  const Pixel l = pixel_at(image, static_cast<int>(lip->first), static_cast<int>(lip->second));
  EXPECT_LT(d.r + d.g + d.b, (l.r + l.g + l.b) / 2);
}

TEST_F(AFrame, APotThatWasCutFreeStandsWhileTheWheelHeadTurnsUnderIt) {
  Renderer& r = renderer();
  ClayView clay = thrown_clay(kCylinder, cylinder, 0.008, 0.0002);
  for (int j = 0; j < clay.rows(); ++j) {  // with a flute, so that its turning is seen
    std::vector<float> outer(clay.outer(j).begin(), clay.outer(j).end());
    for (std::size_t i = 30; i < 50; ++i) outer[i] -= 0.004f;
    clay.shape(j, outer, clay.inner(j));
  }
  r.show_clay(clay);
  view::Frame frame = frame_with_pot(800, 600, 0.15, 0.05);
  const auto changed = [&](const view::Image& a, const view::Image& b, bool of_pot) {
    // The pot's upper half, and the wheel head to the right of its foot.
    const auto low = *frame.pot->camera.project({of_pot ? -0.05 : 0.07, of_pot ? 0.07 : 0.0, 0});
    const auto high = *frame.pot->camera.project({of_pot ? 0.05 : 0.17, of_pot ? 0.16 : 0.02, 0});
    int count = 0;
    for (int y = static_cast<int>(high.second); y < static_cast<int>(low.second); ++y)
      for (int x = static_cast<int>(low.first); x < static_cast<int>(high.first); ++x)
        count += difference(pixel_at(a, x, y), pixel_at(b, x, y)) > 6 ? 1 : 0;
    return count;
  };
  frame.pot->wheel_angle = 0.2;
  frame.pot->clay_angle = 1.0;
  const view::Image before = drawn(r, frame);
  frame.pot->wheel_angle = 0.0;  // the dab of slip comes to the right
  const view::Image turned = drawn(r, frame);
  EXPECT_EQ(changed(before, turned, true), 0);
  EXPECT_GT(changed(before, turned, false), 20);
  frame.pot->clay_angle = 1.5;
  EXPECT_GT(changed(turned, drawn(r, frame), true), 500);
}

TEST_F(AFrame, DrawsTheSamePixelsTwice) {
  Renderer& r = renderer();
  r.show_clay(thrown_clay(kCylinder, cylinder, 0.008, 0.0002));
  view::Frame frame = frame_with_pot(640, 400, 0.15, 0.05);
  frame.pot->wetness = 0.5;
  const view::Image first = drawn(r, frame);
  drawn(r, empty_frame());
  EXPECT_EQ(drawn(r, frame).rgba, first.rgba);
}

TEST_F(AFrame, OffscreenLeavesTheWindowsPictureAlone) {
  Renderer& r = renderer();
  const view::Image before = drawn(r, empty_frame());
  view::Frame card = empty_frame();
  card.width = 300;
  card.height = 420;
  card.items.emplace_back(view::Box{{0, 0, 300, 420}, 0, view::kInk, 0, {}});
  const view::Image image = r.draw_offscreen(card);
  EXPECT_EQ(image.width, 300);
  EXPECT_EQ(image.height, 420);
  EXPECT_LT(pixel_at(image, 150, 200).r, 50);
  EXPECT_EQ(r.read_pixels().rgba, before.rgba);
}

/// Mean of each channel over a tile.
std::array<double, 3> mean_of(const view::Image& image, int x0, int y0, int size) {
  std::array<double, 3> sum{};
  for (int y = y0; y < y0 + size; ++y)
    for (int x = x0; x < x0 + size; ++x) {
      const Pixel p = pixel_at(image, x, y);
      sum[0] += p.r, sum[1] += p.g, sum[2] += p.b;
    }
  for (double& s : sum) s /= size * size;
  return sum;
}

// Of the clay's and the wood's own grain, and of dither, a tile's mean has little left.
TEST_F(AFrame, LitFromTheRightIsTheMirrorImageOfTheOneLitFromTheLeft) {
  constexpr int kTile = 32;
  // So tall that its shadow is longer than the dark round the foot is wide.
  renderer().show_clay(thrown_clay(grid_of(200, 180, 0.30, 0.010), cylinder, 0.006, 0));
  view::Frame frame = frame_with_pot(640, 384, 0.30, 0.05);
  for (const bool wheel : {true, false}) {
    frame.pot->wheel = wheel;
    frame.pot->wetness = 0.5;
    frame.pot->wheel_angle = 1.5707963267948966;  // its dab of slip in front
    frame.pot->window = view::kWindowLeft;
    const view::Image left = drawn(renderer(), frame);
    frame.pot->window = view::kWindowRight;
    const view::Image right = drawn(renderer(), frame);
    keep_for_looking(left, wheel ? "window_left_wheel" : "window_left");
    keep_for_looking(right, wheel ? "window_right_wheel" : "window_right");
    double asymmetric = 0;
    for (int y = 0; y + kTile <= 384; y += kTile)
      for (int x = 0; x + kTile <= 640; x += kTile) {
        const auto a = mean_of(left, x, y, kTile), b = mean_of(right, 640 - kTile - x, y, kTile),
                   c = mean_of(right, x, y, kTile);
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_NEAR(a[k], b[k], 4.0) << x << "," << y << " " << wheel;
          asymmetric = std::max(asymmetric, std::abs(a[k] - c[k]));
        }
      }
    EXPECT_GT(asymmetric, 25.0) << "light and shadow fall to one side";
  }
}

TEST_F(AFrame, LitFromBehindTheVisitorIsItsOwnMirrorImageAndItsShadowGoesRoundWithTheLight) {
  constexpr int kTile = 32;
  renderer().show_clay(thrown_clay(grid_of(200, 180, 0.30, 0.010), cylinder, 0.006, 0));
  view::Frame frame = frame_with_pot(640, 384, 0.30, 0.05);
  frame.pot->wheel = false;
  const auto lit_from = [&](double window) {
    frame.pot->window = window;
    const view::Image image = drawn(renderer(), frame);
    keep_for_looking(image, "window_" + std::to_string(std::lround(100 * window)));
    return image;
  };
  const view::Image front = lit_from(0.0);
  for (int y = 0; y + kTile <= 384; y += kTile)
    for (int x = 0; x + kTile <= 640; x += kTile) {
      const auto a = mean_of(front, x, y, kTile), b = mean_of(front, 640 - kTile - x, y, kTile);
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 4.0) << x << "," << y;
    }
  // The ground at the left of the foot loses light and that at the right gains it, all the way.
  double before = 255.0, first = 0.0, last = 0.0;
  for (const double window : {-1.4, -0.9, -0.45, 0.0, 0.45, 0.9, 1.4}) {
    const view::Image image = lit_from(window);
    last = mean_of(image, 160, 288, kTile)[1] - mean_of(image, 448, 288, kTile)[1];
    if (before == 255.0) first = last;
    EXPECT_LT(last, before) << window;
    before = last;
  }
  EXPECT_GT(first, 25.0);
  EXPECT_NEAR(last, -first, 2.0);
}

// On the question whether to leave a pot, the dark under its foot was seen through its wall.
TEST_F(AFrame, APotThatFadesIsNoWindowOntoItsOwnShadow) {
  renderer().show_clay(thrown_clay(
      grid_of(200, 180, 0.18, 0.012), [](double) { return 0.05; }, 0.006, 0.0));
  view::Frame frame = frame_with_pot(480, 400, 0.18, 0.05);
  frame.pot->wheel = false;
  const auto shown = [&](double opacity) {
    frame.pot->opacity = opacity;
    return renderer().draw_offscreen(frame);
  };
  const view::Image pot = shown(1.0), none = shown(0.0), faded = shown(0.2);
  for (const double back : {-0.6, -0.3, 0.0, 0.3, 0.6}) {
    const auto at = *frame.pot->camera.project({0, 0, 0.05 * back});
    const int x = static_cast<int>(at.first), y = static_cast<int>(at.second);
    const int darkest = std::min(pixel_at(pot, x, y).g, pixel_at(none, x, y).g);
    EXPECT_GE(pixel_at(faded, x, y).g, darkest - 3) << back;
    const double mixed = 0.2 * pixel_at(pot, x, y).g + 0.8 * pixel_at(none, x, y).g;
    EXPECT_NEAR(pixel_at(faded, x, y).g, mixed, 6) << back;
  }
}

TEST_F(AFrame, CharcoalInAPotGlowsOnItsInsideAndNotOnItsOutside) {
  Renderer& r = renderer();
  r.show_clay(thrown_clay(kCylinder, cylinder, 0.006, 0.0));
  view::Frame frame = frame_with_pot(1280, 720, 0.15, 0.05);
  frame.pot->cut_away = 1.0;
  const view::Image cold = r.draw_offscreen(frame);
  frame.pot->embers = 1.0;
  const view::Image hot = r.draw_offscreen(frame);
  keep_for_looking(hot, "charcoal");
  const auto at = [&](const view::Image& image, Vec3 place) {
    const auto pixel = *frame.pot->camera.project(place);
    return pixel_at(image, static_cast<int>(pixel.first), static_cast<int>(pixel.second));
  };
  const Vec3 inside{0.02, 0.066, -0.0392}, outside{-0.046, 0.066, 0.0195};
  EXPECT_GT(at(hot, inside).r, at(cold, inside).r + 15);
  EXPECT_GT(at(hot, inside).r - at(cold, inside).r, at(hot, inside).b - at(cold, inside).b + 10)
      << "it is red";
  EXPECT_EQ(difference(at(hot, outside), at(cold, outside)), 0);
}

}  // namespace
}  // namespace onggi::render::testing::frame_test
