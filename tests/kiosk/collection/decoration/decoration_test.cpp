#include "kiosk/collection/decoration/decoration.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::decoration::decoration_test {
namespace {

DecorationRead read(const std::string& text) {
  const files::test::ScratchFolder folder;
  const std::string file = folder / "decoration.toml";
  std::ofstream(file) << text;
  return check_decoration(file);
}

constexpr const char* kHead =
    "sources = \"a book\"\nsimplified = \"nothing\"\nbody = \"#FFFFFF\"\n"
    "[pigment.blue]\ncolor = \"#0000FF\"\nhides_um = 20\n";
constexpr const char* kDiamond =
    "[[motif.diamond.fill]]\npoints = [[-1, 0, \"corner\"], [0, 1, \"corner\"], [1, 0, "
    "\"corner\"]]\n";

TEST(DecorationFile, IsReadStepByStep) {
  const DecorationRead found =
      read(std::string(kHead) + kDiamond +
           "[[step]]\ndo = \"coat\"\nwith = \"glaze\"\nfrom = 0.1\n"
           "[[step]]\ndo = \"paint\"\nmotif = \"diamond\"\nwith = \"blue\"\n"
           "at = 0.7\nsize_mm = 12\nrepeat = 8\nthickness_um = 50\n");
  ASSERT_TRUE(found.problems.empty()) << to_text(found.problems[0]);
  const Decoration& d = found.decoration;
  ASSERT_EQ(d.steps.size(), 2u);
  EXPECT_EQ(d.body[0], 1.0f);
  EXPECT_DOUBLE_EQ(d.pigments[0].hides, 2e-5);
  EXPECT_EQ(d.steps[0].pigment, kGlaze);
  EXPECT_EQ(d.steps[1].kind, Step::paint);
  EXPECT_EQ(d.steps[1].pigment, 0);
  EXPECT_DOUBLE_EQ(d.steps[1].size, 0.012);
  EXPECT_EQ(d.steps[1].repeat, 8);
  EXPECT_EQ(d.steps[1].motif.fills.size(), 1u);
}

TEST(DecorationFile, EachFaultHasItsLineAndARemedy) {
  const auto fault = [](const std::string& more) {
    const DecorationRead found = read(std::string(kHead) + kDiamond + more);
    EXPECT_EQ(found.problems.size(), 1u) << more;
    if (found.problems.empty()) return std::string();
    EXPECT_NE(found.problems[0].where.find("decoration.toml:"), std::string::npos);
    EXPECT_FALSE(found.problems[0].remedy.empty());
    return found.problems[0].what;
  };
  EXPECT_EQ(fault("[[step]]\ndo = \"weave\"\n"), "do is \"weave\", which nobody does here.");
  EXPECT_EQ(fault("[[step]]\ndo = \"band\"\nat = 0.5\nwith = \"green\"\n"),
            "there is no pigment \"green\".");
  EXPECT_EQ(fault("[[step]]\ndo = \"band\"\nat = 0.5\nwith = \"glaze\"\n"),
            "there is no pigment \"glaze\".");
  EXPECT_EQ(fault("[[step]]\ndo = \"cut\"\nat = 0.5\nmotif = \"fish\"\n"),
            "there is no motif \"fish\".");
  EXPECT_EQ(fault("[[step]]\ndo = \"coat\"\nwith = \"blue\"\nfrom = 0.6\nto = 0.6\n"),
            "the zone ends where it begins, or below.");
  EXPECT_NE(fault("[[step]]\ndo = \"smoke\"\nfrom = 1.5\n"), "");
  EXPECT_EQ(fault("[[motif.dash.line]]\npoints = [[0, 0], [1, 0]]\n"
                  "[[step]]\ndo = \"stamp\"\nat = 0.5\nmotif = \"dash\"\n"),
            "the motif has no area, so a stamp of it presses nothing.");
  EXPECT_EQ(fault("[[step]]\ndo = \"cut\"\nat = 0.5\nsunk = true\nsection = \"u\"\n"),
            "the cut has a section, too.");
  EXPECT_NE(fault("[[step]]\ndo = \"scrape\"\n"), "");
  EXPECT_NE(fault("[[step]]\ndo = \"burnish\"\nfrom = 0.1\nmotif = \"diamond\"\n"), "");
  EXPECT_NE(fault("[[step]]\ndo = \"coil\"\nat = 0.5\nmarks = 3\n"), "");
  EXPECT_NE(fault("[[step]]\ndo = \"coat\"\nwith = \"blue\"\nfrmo = 0.2\n"), "");
  EXPECT_EQ(fault("[motif.dot]\n"), "the motif \"dot\" has nothing to draw.");
  EXPECT_EQ(fault("[[step]]\ndo = \"cut\"\nat = 0.5\nmotif = \"diamond\"\nrepeat = 9\n"),
            "repeat is 9, which does not divide the pot evenly.");
  EXPECT_EQ(fault("[[motif.dot.line]]\npoints = [[0, 0], [1e30, 0.2]]\n"),
            "a point lies farther than 1000 units from the middle.");
  EXPECT_EQ(fault("[[motif.dot.fill]]\npoints = [[0, 0], [1, 1]]\n"),
            "it has 2 points, but needs 3 to 500.");
}

TEST(DecorationFile, SaysFromWhereItIsKnown) {
  for (const char* key : {"sources", "simplified"})
    for (const char* nothing : {"", " \\n\\t"}) {
      std::string text = kHead;
      const auto from = text.find('"', text.find(key)) + 1;
      text.replace(from, text.find('"', from) - from, nothing);
      const DecorationRead found = read(text);
      ASSERT_EQ(found.problems.size(), 1u) << text;
      EXPECT_EQ(found.problems[0].what, std::string(key) + " is empty.");
      EXPECT_TRUE(found.problems[0].where.ends_with(key[1] == 'o' ? ":1:11" : ":2:14"))
          << found.problems[0].where;
      EXPECT_FALSE(found.problems[0].remedy.empty());
    }
}

TEST(DecorationFile, AFileThatIsNotThereIsOneProblem) {
  EXPECT_FALSE(read_decoration("no/such/decoration.toml"));
}

// Through the points, and straight from corner to corner.
TEST(Smooth, GoesThroughItsPointsAndKeepsCorners) {
  const std::vector<toml::OutlinePoint> points{{0, 0, false}, {1, 1, false}, {2, 0, false}};
  const std::vector<Vec2> open = smooth(points, false);
  EXPECT_EQ(open.size(), 17u);
  EXPECT_EQ(open.front(), (Vec2{0, 0}));
  EXPECT_EQ(open[8], (Vec2{1, 1}));
  EXPECT_EQ(open.back(), (Vec2{2, 0}));
  EXPECT_GT(open[12].y, 2.0 - open[12].x);  // rounder than the chord
  const std::vector<Vec2> closed = smooth(points, true);
  EXPECT_EQ(closed.size(), 24u);
  std::vector<toml::OutlinePoint> sharp = points;
  for (auto& p : sharp) p.corner = true;
  for (const Vec2& p : smooth(sharp, false)) EXPECT_NEAR(p.y, p.x <= 1.0 ? p.x : 2.0 - p.x, 1e-12);
}

}  // namespace
}  // namespace onggi::decoration::decoration_test
