#include <algorithm>
#include <cmath>
#include <cstdio>

#include "kiosk/collection/content/glaze.h"
#include "tests/kiosk/picture/render/studio_fixture.h"

// What a pot looks like as it dries, is cut open, and is fired.

namespace onggi::render::testing::kiln_look_test {
namespace {

using KilnLook = StudioTest;

double straight(double) { return 0.06; }
const ClayDef kShape = grid_of(200, 180, 0.18, 0.012);

double brightness(const view::Image& image, int x, int y) {
  const Pixel p = pixel_at(image, x, y);
  return 0.2126 * p.r + 0.7152 * p.g + 0.0722 * p.b;
}

/// Mean over a patch of the outer wall at `height`, in front.
double wall_brightness(const view::Image& image, const view::Camera& camera, double height) {
  const auto at = *camera.project({0, height, 0.06});
  double sum = 0;
  for (int dx = -30; dx <= 30; dx += 5)
    for (int dy = -8; dy <= 8; dy += 2)
      sum += brightness(image, static_cast<int>(at.first) + dx, static_cast<int>(at.second) + dy);
  return sum / (13 * 9);
}

void put_pot(Renderer& r) { r.show_clay(thrown_clay(kShape, straight, 0.006, 0.00015)); }

TEST_F(KilnLook, AWetRowIsDarkerThanADryOneAndDriesBackToTheSamePicture) {
  Renderer& r = renderer();
  put_pot(r);
  view::Frame frame = frame_with_pot(kWidth, kHeight, 0.18, 0.06);
  frame.pot->wheel = false;
  const view::Image dry = r.draw_offscreen(frame);
  frame.pot->wetness_by_row.assign(64, 0.0f);
  EXPECT_EQ(r.draw_offscreen(frame).rgba, dry.rgba) << "rows without water are dry clay";
  for (std::size_t i = 16; i < 32; ++i) frame.pot->wetness_by_row[i] = 1.0f;
  const view::Image wet = r.draw_offscreen(frame);
  keep_for_looking(wet, "wet_band");
  const view::Camera& camera = frame.pot->camera;
  EXPECT_LT(wall_brightness(wet, camera, 0.375 * 0.18),
            0.75 * wall_brightness(dry, camera, 0.375 * 0.18));
  EXPECT_NEAR(wall_brightness(wet, camera, 0.75 * 0.18), wall_brightness(dry, camera, 0.75 * 0.18),
              1.0);
  double before = wall_brightness(wet, camera, 0.375 * 0.18);
  for (const float left : {0.7f, 0.4f, 0.15f}) {
    for (std::size_t i = 16; i < 32; ++i) frame.pot->wetness_by_row[i] = left;
    const view::Image drying = r.draw_offscreen(frame);
    keep_for_looking(drying, "wet_band_" + std::to_string(static_cast<int>(100 * left)));
    const double now = wall_brightness(drying, camera, 0.375 * 0.18);
    EXPECT_GT(now, before) << left;
    before = now;
  }
}

/// How much the brightness of a wall changes from pixel to pixel on its way round, as a share.
double unevenness(const view::Image& image, const view::Camera& camera, double height) {
  const auto at = *camera.project({0, height, 0.06});
  const int x = static_cast<int>(at.first), y = static_cast<int>(at.second);
  constexpr int kHalf = 60, kAbout = 12;
  double sum = 0.0, count = 0.0;
  for (int dy = -20; dy <= 20; dy += 4)
    for (int dx = -kHalf; dx <= kHalf; ++dx) {
      double mean = 0.0;
      for (int k = -kAbout; k <= kAbout; ++k) mean += brightness(image, x + dx + k, y + dy);
      mean /= 2 * kAbout + 1;
      sum += std::pow(brightness(image, x + dx, y + dy) / mean - 1.0, 2);
      ++count;
    }
  return std::sqrt(sum / count);
}

// A film of water is even: clay that dries has no spots, as leather has.
TEST_F(KilnLook, ClayIsAsEvenWetAsDry) {
  Renderer& r = renderer();
  put_pot(r);
  view::Frame frame = frame_with_pot(kWidth, kHeight, 0.18, 0.06);
  double dry = 0.0;
  for (const double wet : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    frame.pot->wetness = wet;
    const view::Image image = r.draw_offscreen(frame);
    keep_for_looking(image, "wet_" + std::to_string(static_cast<int>(100 * wet)));
    const double now = unevenness(image, frame.pot->camera, 0.09);
    std::printf("wet %.2f: brightness changes by %.4f\n", wet, now);
    if (wet == 0.0) dry = now;
    EXPECT_LE(now, 1.05 * dry) << wet;
  }
  EXPECT_GT(dry, 0.002) << "dry clay has a grain";
}

TEST_F(KilnLook, AFiredPotIsSeenSmallerByJustWhatItShrank) {
  Renderer& r = renderer();
  put_pot(r);
  view::Frame frame = frame_with_pot(kWidth, kHeight, 0.18, 0.06);
  frame.pot->wheel = false;
  frame.pot->finish = view::Finish::fired;
  frame.pot->glazing.look.glass = frame.pot->glazing.look.body = {0.01f, 0.01f, 0.01f};
  const auto width_at = [&](const view::Image& image, double height) {
    const auto at = *frame.pot->camera.project({0, height, 0});
    // A black pot before pale plaster: from well outside inwards on either side.
    const int y = static_cast<int>(at.second);
    int left = static_cast<int>(at.first) - 250, right = static_cast<int>(at.first) + 250;
    while (brightness(image, left, y) > 95) ++left;
    while (brightness(image, right, y) > 75) --right;
    return right - left;
  };
  const int thrown = width_at(r.draw_offscreen(frame), 0.10);
  for (const double size : {0.9375, 0.875}) {
    frame.pot->size = size;
    const view::Image image = r.draw_offscreen(frame);
    EXPECT_NEAR(width_at(image, 0.10 * size), thrown * size, 0.02 * thrown) << size;
  }
}

TEST_F(KilnLook, EveryGlazeLooksUnlikeTheOthersAndUnlikeClay) {
  Renderer& r = renderer();
  put_pot(r);
  view::Frame frame = frame_with_pot(kWidth, kHeight, 0.18, 0.06);
  std::vector<Pixel> seen;
  const auto look = [&] {
    const auto at = *frame.pot->camera.project({0, 0.06, 0.06});
    const view::Image image = r.draw_offscreen(frame);
    Pixel sum;
    for (int dx = -20; dx < 20; ++dx) {
      const Pixel p =
          pixel_at(image, static_cast<int>(at.first) + 40 + dx, static_cast<int>(at.second));
      sum = {sum.r + p.r, sum.g + p.g, sum.b + p.b};
    }
    for (const Pixel& other : seen)
      EXPECT_GT(std::abs(sum.r - other.r) + std::abs(sum.g - other.g) + std::abs(sum.b - other.b),
                40 * 24)
          << seen.size();
    seen.push_back(sum);
  };
  look();
  frame.pot->finish = view::Finish::fired;
  const auto glazes = content::read_glazes("content/glazes.toml").glazes;
  for (const content::Glaze& glaze : glazes) {
    frame.pot->glazing.look = glaze.look;
    look();
  }
}

TEST_F(KilnLook, AFiringBeginsAsDryClayAndEndsAsTheGlazedPot) {
  Renderer& r = renderer();
  put_pot(r);
  view::Frame frame = frame_with_pot(kWidth, kHeight, 0.18, 0.06);
  const auto far = [](const view::Image& a, const view::Image& b) {
    int most = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i)
      most = std::max(most, std::abs(int{a.rgba[i]} - int{b.rgba[i]}));
    return most;
  };
  const view::Image clay = r.draw_offscreen(frame);
  frame.pot->finish = view::Finish::firing;
  frame.pot->firing = {std::nullopt, 0.0, 0.0};
  EXPECT_LE(far(clay, r.draw_offscreen(frame)), 2);
  frame.pot->firing.done = 1.0;
  const view::Image done = r.draw_offscreen(frame);
  frame.pot->finish = view::Finish::fired;
  EXPECT_LE(far(done, r.draw_offscreen(frame)), 2);
}

// The section is what archaeologists would draw: as thick as the clay is, at every height.
TEST_F(KilnLook, TheCutAwayShowsTheWallAsThickAsItIsWhileItThins) {
  Renderer& r = renderer();
  for (const double rim_wall : {0.012, 0.006, 0.003}) {
    const auto wall_at = [&](double height) {
      return 0.014 + (rim_wall - 0.014) * height / kShape.height;
    };
    ClayView clay;
    clay.lay(kShape);
    const auto sectors = static_cast<std::size_t>(kShape.sectors);
    for (int j = 0; j < kShape.rows; ++j) {
      const auto inside = static_cast<float>(0.06 - wall_at(clay.row_height(j)));
      clay.shape(j, std::vector<float>(sectors, 0.06f),
                 std::vector<float>(sectors, j < clay.floor_rows() ? 0.0f : inside));
    }
    r.show_clay(clay);
    view::Frame frame = frame_with_pot(2000, 2000, 0.18, 0.06);
    frame.pot->cut_away = 1.0;
    const view::Image image = r.draw_offscreen(frame);
    keep_for_looking(image, "cut_" + std::to_string(static_cast<int>(1000 * rim_wall)));
    const view::Camera& camera = frame.pot->camera;
    Vec3 right, up, back;
    camera.basis(right, up, back);
    for (double h = 0.03; h < 0.165; h += 0.015) {
      const auto at = [&](double radius) {
        return *camera.project({right.x * radius, h, right.z * radius});
      };
      const auto outer = at(0.06), inner = at(0.06 - wall_at(h));
      const int y = static_cast<int>(outer.second);
      // From the middle of the wall to the ink of either edge.
      const int middle = static_cast<int>(0.5f * (outer.first + inner.first));
      int from = middle, to = middle;
      while (from > 0 && brightness(image, from, y) > 160) --from;
      while (to < image.width - 1 && brightness(image, to, y) > 160) ++to;
      EXPECT_NEAR(to - from, static_cast<double>(outer.first - inner.first), 3.0)
          << "wall of " << 1000 * wall_at(h) << " mm at " << h;
    }
  }
}

}  // namespace
}  // namespace onggi::render::testing::kiln_look_test
