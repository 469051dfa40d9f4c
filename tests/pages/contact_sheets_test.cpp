#include "tests/pages/contact_sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>

#include "kiosk/collection/textures/texture_decoder.h"
#include "kiosk/ground/files/virtual_display.h"
#include "tests/kiosk/program/commands/temporary_exhibit.h"

namespace onggi::pages {
namespace {

/// Mean of the differences of two parts of a picture, 0..255.
double apart(const textures::TexturePixels& image, int ax, int ay, int bx, int by, int w, int h) {
  double sum = 0;
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x)
      for (int k = 0; k < 3; ++k) {
        const auto at = [&](int px, int py) {
          return int{image.rgb[static_cast<std::size_t>(3 * (py * image.width + px) + k)]};
        };
        sum += std::abs(at(ax + x, ay + y) - at(bx + x, by + y));
      }
  return sum / (3.0 * w * h);
}

/// From the lightest to the darkest pixel of a part.
int contrast(const textures::TexturePixels& image, int x0, int y0, int w, int h) {
  int low = 255, high = 0;
  for (int y = y0; y < y0 + h; ++y)
    for (int x = x0; x < x0 + w; ++x) {
      const int g = image.rgb[static_cast<std::size_t>(3 * (y * image.width + x) + 1)];
      low = std::min(low, g), high = std::max(high, g);
    }
  return high - low;
}

// A picture that is drawn at once has at most 4096 pixels a side: what lies beyond was lost.
TEST(ContactSheets, ASheetThatIsLargerThanAnyPictureIsWholeToItsLastRowAndColumn) {
  auto display = files::VirtualDisplay::ensure(640, 360);
  if (!display) GTEST_SKIP() << "no display, and Xvfb is not installed";
  const commands::ScratchFolder folder;
  std::filesystem::create_directories(folder / "shelf");
  std::filesystem::copy("content/vessels/tea_bowl", folder / "shelf/tea_bowl",
                        std::filesystem::copy_options::recursive);
  exhibit::KioskOptions options;
  options.config = commands::write_exhibit(folder, "paper", "[store]\ncount = false\n");
  options.shelf = folder / "shelf";
  options.keepsakes = folder / "kept";
  options.window = {.width = 640, .height = 360, .visible = false, .title = "Onggi tests"};
  options.devices = false;
  options.stepped = true;
  auto opened = exhibit::Kiosk::open(options);
  ASSERT_TRUE(opened) << to_text(opened.error());
  exhibit::Kiosk& kiosk = **opened;
  double now = 0;
  for (int n = 0; n < 5000 && !kiosk.doing().open_to_visitors; ++n) kiosk.frame(now += 0.01, false);
  ASSERT_TRUE(kiosk.doing().open_to_visitors);

  // One state more than 4096 pixels hold, each 106 high; and one sight, 158 wide. It is drawn once.
  constexpr int kStates = 40, kSights = 27;
  const Sight sight{640, 360, "en", ""};
  const std::vector<SheetPlan> plans{{"tall", {sight}},
                                     {"wide", std::vector<Sight>(kSights, sight)}};
  const auto walk = [&](int states) {
    return [=](const LookAtScreen& look) -> Result<void> {
      for (int n = 0; n < states; ++n)
        if (auto good = look("state " + std::to_string(n)); !good) return good;
      return {};
    };
  };
  const auto sheet = [&](const SheetPlan& plan, int states) {
    const auto drawn = draw_contact_sheets(kiosk, walk(states), {plan}, folder / "sheets", false,
                                           [](const std::string&) {});
    EXPECT_TRUE(drawn) << (drawn ? "" : to_text(drawn.error()));
    const std::string bytes = commands::content(folder / ("sheets/" + plan.name + ".jpg"));
    auto read = textures::decode_texture(
        {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, {8192, 8192});
    EXPECT_TRUE(read) << (read ? "" : read.error());
    return read ? *read : textures::TexturePixels{};
  };
  const textures::TexturePixels tall = sheet(plans[0], kStates);
  ASSERT_GT(tall.height, 4096);
  // 16 of margin, 22 the sight's name, and then 22 of a state's name over each picture of 150 x 84.
  const auto row = [](int n) { return 16 + 22 + n * 106; };
  ASSERT_GE(tall.height, row(kStates));
  for (int n = 0; n < kStates; ++n) {
    EXPECT_LT(apart(tall, 16, row(0) + 22, 16, row(n) + 22, 150, 84), 3.0) << n;
    EXPECT_GT(contrast(tall, 16, row(n) + 24, 150, 80), 60) << "something is on picture " << n;
    EXPECT_GT(contrast(tall, 16, row(n) + 1, 60, 20), 100) << "the name of state " << n;
  }
  const textures::TexturePixels wide = sheet(plans[1], 1);
  ASSERT_GT(wide.width, 4096);
  for (int n = 0; n < kSights; ++n) {
    EXPECT_LT(apart(wide, 16, 60, 16 + 158 * n, 60, 150, 84), 3.0) << n;
    EXPECT_GT(contrast(wide, 16 + 158 * n, 17, 150, 20), 100) << "the name of sight " << n;
  }
}

}  // namespace
}  // namespace onggi::pages
