#include "kiosk/program/console/side_view.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "kiosk/collection/content/drawing.h"

namespace onggi::console::side_view_test {
namespace {

std::vector<Vec2> points_of(const std::string& svg) {
  std::string path = svg.substr(svg.find("d=\"M") + 4);
  path.resize(path.find('Z'));
  for (char& c : path)
    if (c == 'L') c = ' ';
  std::istringstream in(path);
  std::vector<Vec2> points;
  for (Vec2 point; in >> point.x >> point.y;) points.push_back(point);
  return points;
}

TEST(SideView, OfEveryVesselStandsInThePictureAsWideToTheLeftAsToTheRight) {
  int vessels = 0;
  for (const auto& folder : std::filesystem::directory_iterator("content/vessels")) {
    const auto drawing = content::read_drawing(folder.path() / "profile.toml");
    if (!drawing) continue;
    const auto points = points_of(side_view(drawing->section));
    ASSERT_GT(points.size(), 8u) << folder;
    double top = 100, low = 0, left = 100, right = 0;
    for (const Vec2& p : points) {
      top = std::min(top, p.y), low = std::max(low, p.y);
      left = std::min(left, p.x), right = std::max(right, p.x);
    }
    EXPECT_NEAR(low, 100, 0.1) << folder;
    EXPECT_NEAR(left + right, 100, 0.2) << folder;
    EXPECT_NEAR(std::max(low - top, right - left), 100, 0.2) << folder;
    ++vessels;
  }
  EXPECT_GE(vessels, 12);
}

TEST(SideView, LeavesTheInsideOut) {
  // A cup of 10 cm, 8 wide, with a wall of 1 cm.
  const Section cup{{{0, 0}, {0.04, 0}, {0.04, 0.1}, {0.03, 0.1}, {0.03, 0.01}, {0, 0.01}}};
  EXPECT_EQ(points_of(side_view(cup)).size(), 6u);
}

TEST(SideView, OfNothingIsNothing) { EXPECT_EQ(side_view({}), ""); }

}  // namespace
}  // namespace onggi::console::side_view_test
