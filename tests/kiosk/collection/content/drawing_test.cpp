#include "kiosk/collection/content/drawing.h"

#include <algorithm>

#include "engine/profile/mesh.h"
#include "tests/engine/profile/shapes.h"
#include "tests/kiosk/collection/content/temporary.h"

namespace onggi::content::drawing_test {
namespace {

const std::string kHead = "title = \"Cup\"\nsource = \"Drawn for a test\"\nunits = \"mm\"\n";
const std::string kCup = kHead +
                         "outer = [[30, 0], [34, 20], [40, 60], [41, 80]]\n"
                         "inner = [[37, 80], [36, 60], [28, 15], [0, 6]]\n";

class DrawingTest : public Temporary {
 protected:
  /// Every Problem of a drawing, as it is printed.
  std::string problems(const std::string& text) {
    std::string out;
    for (const Problem& p : check_drawing(write("profile.toml", text)).problems)
      out += to_text(p) + "\n";
    return out;
  }
};

TEST_F(DrawingTest, a_drawn_cup_becomes_a_section_in_metres) {
  const auto drawing = read_drawing(write("profile.toml", kCup));
  ASSERT_TRUE(drawing) << to_text(drawing.error());
  EXPECT_EQ(drawing->title, "Cup");
  const auto& outline = drawing->section.outline;
  EXPECT_EQ(outline.front(), (Vec2{0, 0}));
  EXPECT_EQ(outline.back(), (Vec2{0, 0.006}));
  double top = 0, widest = 0;
  for (const Vec2& p : outline) {
    top = std::max(top, p.y);
    widest = std::max(widest, p.x);
    EXPECT_GE(p.x, 0.0);
    EXPECT_GE(p.y, 0.0);
  }
  EXPECT_DOUBLE_EQ(top, 0.08);
  EXPECT_DOUBLE_EQ(widest, 0.041);
  const TriangleMesh mesh = revolve(drawing->section, 48);
  EXPECT_EQ(shapes::open_edges(mesh), 0);
  EXPECT_GT(shapes::volume(mesh), 0.0);
}

TEST_F(DrawingTest, a_foot_ring_is_hollow_below) {
  const auto drawing =
      read_drawing(write("profile.toml", kCup + "[foot]\nring_inner_radius = 25\nrecess = 4\n"));
  ASSERT_TRUE(drawing) << to_text(drawing.error());
  EXPECT_EQ(drawing->section.outline[0], (Vec2{0, 0.004}));
  EXPECT_EQ(drawing->section.outline[1], (Vec2{0.025, 0.004}));
  EXPECT_EQ(drawing->section.outline[2], (Vec2{0.025, 0}));
}

TEST_F(DrawingTest, a_rounded_rim_keeps_its_height_and_loses_its_edges) {
  const auto sharp = read_drawing(write("a.toml", kCup));
  const auto round = read_drawing(write("b.toml", kCup + "[rim]\nrounding = 1.5\n"));
  ASSERT_TRUE(sharp && round);
  const auto sharpest = [](const Section& s) {
    double least = 1.0;
    for (std::size_t i = 1; i + 1 < s.outline.size(); ++i) {
      const Vec2 a = s.outline[i] - s.outline[i - 1], b = s.outline[i + 1] - s.outline[i];
      if (s.outline[i].y > 0.07) least = std::min(least, dot(a, b) / (length(a) * length(b)));
    }
    return least;
  };
  EXPECT_LT(sharpest(sharp->section), 0.2);
  EXPECT_GT(sharpest(round->section), 0.9);
  double top = 0;
  for (const Vec2& p : round->section.outline) top = std::max(top, p.y);
  EXPECT_NEAR(top, 0.08, 1e-9);
}

TEST_F(DrawingTest, a_smooth_line_never_leaves_the_box_of_its_two_neighbours) {
  const auto drawing = read_drawing(
      write("profile.toml", kHead + "outer = [[30, 0], [60, 5], [61, 50], [20, 55], [21, 90]]\n"
                                    "inner = [[17, 90], [16, 52], [50, 46], [50, 12], [0, 10]]\n"));
  ASSERT_TRUE(drawing) << to_text(drawing.error());
  for (const Vec2& p : drawing->section.outline) EXPECT_LE(p.x, 0.061 + 1e-12);
}

TEST_F(DrawingTest, a_corner_is_kept_and_smooth_can_be_switched_off) {
  const auto keel = read_drawing(write(
      "profile.toml", kHead + "outer = [[30, 0], [60, 40, \"corner\"], [30, 80]]\n"
                              "inner = [[26, 80], [52, 40, \"corner\"], [0, 6, \"corner\"]]\n"));
  ASSERT_TRUE(keel) << to_text(keel.error());
  const auto straight = read_drawing(write("b.toml", "smooth = false\n" + kCup));
  ASSERT_TRUE(straight);
  EXPECT_EQ(straight->section.outline.size(), 9u);
}

TEST_F(DrawingTest, what_is_wrong_is_said_with_line_and_column) {
  const auto says = [&](const std::string& text, const std::string& words,
                        const std::string& place) {
    const std::string said = problems(text);
    EXPECT_NE(said.find(words), std::string::npos) << said;
    EXPECT_NE(said.find("profile.toml:" + place), std::string::npos) << said;
  };
  const auto cup = [](const std::string& outer, const std::string& inner) {
    return kHead + "outer = " + outer + "\ninner = " + inner + "\n";
  };
  says(cup("[[30, 0], [40, 80]]", "[[37, 80], [45, 40], [0, 6]]"), "crosses", "5:");
  says(cup("[[30, 0], [40, 80]]", "[[37, 80], [34.5, 40], [0, 6]]"), "thick here", "5:20");
  says(cup("[[30, 0], [-4, 40], [40, 80]]", "[[37, 80], [0, 6]]"), "cannot be negative", "4:19");
  says(cup("[[30, 3], [40, 80]]", "[[37, 80], [0, 6]]"), "begins at height 3 mm", "4:10");
  says(cup("[[30, 0], [40, 80]]", "[[39.5, 80], [0, 6]]"), "must be at least 1 mm inside", "5:10");
  says(cup("[[30, 0], [40, 80]]", "[[37, 60], [0, 6]]"), "the rim is open", "5:10");
  says(cup("[[30, 0], [40, 80]]", "[[37, 80], [3, 6]]"), "must end on the axis", "5:20");
  says(cup("[[30, 0], [30, 0], [40, 80]]", "[[37, 80], [0, 6]]"), "same as", "4:19");
  says(kCup + "[foot]\nring_inner_radius = 29.5\nrecess = 3\n", "foot ring", "7:");
  says(kCup + "[foot]\nrecess = 3\n", "needs both", "6:");
  says(kCup + "[foot]\nring_inner_radius = 20\nrecess = 5.5\n", "thick here", "5:");
  says("unit = \"mm\"\n" + kCup, "unit is not a key", "1:");
  EXPECT_NE(problems("title = \"x\"\n").find("outer is missing"), std::string::npos);
  EXPECT_NE(problems("title = ").find("profile.toml:1:"), std::string::npos);
}

TEST_F(DrawingTest, every_drawing_of_the_exhibit_is_sound) {
  const std::filesystem::path shelf = "content/vessels";
  if (!std::filesystem::exists(shelf)) GTEST_SKIP() << "there is no " << shelf;
  for (const auto& pack : std::filesystem::directory_iterator(shelf)) {
    const auto file = pack.path() / "profile.toml";
    if (!std::filesystem::exists(file)) continue;
    const auto drawing = read_drawing(file);
    ASSERT_TRUE(drawing) << to_text(drawing.error());
    EXPECT_EQ(shapes::open_edges(revolve(drawing->section, 32)), 0) << file;
  }
}

}  // namespace
}  // namespace onggi::content::drawing_test
