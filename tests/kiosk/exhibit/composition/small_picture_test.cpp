#include "kiosk/exhibit/composition/small_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tests/engine/profile/shapes.h"

namespace onggi::exhibit::small_picture_test {
namespace {

constexpr std::uint8_t kPlaster = 230, kDark = 90;

view::Image all_of(std::uint8_t grey, int width, int height) {
  return {width, height,
          std::vector<std::uint8_t>(static_cast<std::size_t>(4 * width * height), grey)};
}

/// Dark everywhere: a shadow without end, and a pot in it.
struct Faded {
  explicit Faded(const Profile& pot)
      : made(pot),
        frame(small_picture(pot, std::nullopt)),
        image(with_soft_shadow(all_of(kDark, frame.width, frame.height),
                               all_of(kPlaster, frame.width, frame.height), frame.pot->camera,
                               pot)) {}
  int at(int x, int y) const {
    return image.rgba[static_cast<std::size_t>(4 * (y * image.width + x))];
  }
  Profile made;
  view::Frame frame;
  view::Image image;
};

const Profile kPots[] = {shapes::jar(), shapes::bottle(), shapes::bowl(),
                         shapes::cylinder(0.06, 0.16, 0.15, 0.01)};

TEST(SmallPicture, ShadowReachesNoEdge) {
  for (const Profile& pot : kPots) {
    const Faded f(pot);
    for (int x = 0; x < f.image.width; ++x) {
      EXPECT_EQ(f.at(x, 0), kPlaster);
      EXPECT_EQ(f.at(x, f.image.height - 1), kPlaster) << x;
    }
    for (int y = 0; y < f.image.height; ++y) {
      EXPECT_EQ(f.at(0, y), kPlaster);
      EXPECT_EQ(f.at(f.image.width - 1, y), kPlaster) << y;
    }
  }
}

TEST(SmallPicture, NothingOfThePotFades) {
  for (const Profile& pot : kPots) {
    const Faded f(pot);
    const view::Camera& camera = f.frame.pot->camera;
    const double pixel =
        1.0 / std::abs(camera.project({0.5, 0, 0})->first - camera.project({-0.5, 0, 0})->first);
    for (int j = 0; j <= 40; ++j)
      for (int i = 0; i < 24; ++i) {
        const double y = pot.height() * j / 40, a = 6.2831853 * i / 24,
                     r = pot.outer_at(y) - 2.5 * pixel;
        const auto p = camera.project({r * std::cos(a), y, r * std::sin(a)});
        ASSERT_TRUE(p);
        EXPECT_EQ(f.at(static_cast<int>(p->first), static_cast<int>(p->second)), kDark)
            << j << " " << i;
      }
  }
}

// From the foot to the right edge the shadow goes lightly, where no pot stands before it.
TEST(SmallPicture, TheShadowFadesWithoutAStep) {
  const Faded f(shapes::jar());
  const auto foot = f.frame.pot->camera.project({f.made.outer_at(0), 0, 0});
  ASSERT_TRUE(foot);
  const int y = static_cast<int>(foot->second);
  int darkest = kPlaster;
  for (int x = static_cast<int>(foot->first) + 2; x + 1 < f.image.width; ++x) {
    EXPECT_GE(f.at(x + 1, y), f.at(x, y)) << x;
    EXPECT_LT(f.at(x + 1, y) - f.at(x, y), 8) << x;
    darkest = std::min(darkest, f.at(x, y));
  }
  EXPECT_LT(darkest, kDark + 40) << "beside the foot it is as dark as it was";
}

}  // namespace
}  // namespace onggi::exhibit::small_picture_test
