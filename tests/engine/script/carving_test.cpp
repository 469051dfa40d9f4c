#include "engine/script/carving.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/scene/scene.h"
#include "tests/support/sanitized.h"

namespace onggi::carving_test {
namespace {

constexpr double kPi = 3.14159265358979323846;

struct Grid {
  int rows, sectors;
};
// Under sanitizers the kernels are not optimised, and the finer grid takes minutes.
constexpr Grid kGrids[] = {
    {200, 360},
#if !ONGGI_SANITIZED
    {400, 720},
#endif
};

SceneDef scene_on(Grid grid) {
  SceneDef def;
  def.clay.rows = grid.rows;
  def.clay.sectors = grid.sectors;
  return def;
}

struct Carved {
  std::unique_ptr<Scene> scene;
  Feedback last;
  const Clay& clay() const { return scene->clay(); }
  double outer(int j, int i) const {
    const int n = clay().sectors();
    return double{clay().outer(j)[static_cast<std::size_t>((i % n + n) % n)]};
  }
};

Carved carve(std::string_view name, Grid grid) {
  const SceneDef def = scene_on(grid);
  Carved out{std::make_unique<Scene>(std::move(*Scene::create(def))), {}};
  auto script = make_script(name, {.scene = def});
  EXPECT_TRUE(script) << to_text(script.error());
  for (long n = 0; static_cast<double>(n) * 0.001 <= (*script)->duration() + 0.01; ++n) {
    const double t = static_cast<double>(n) * 0.001;
    out.last = out.scene->step((*script)->at(t, out.clay()), 0.001);
    EXPECT_EQ(out.last.faults, 0u);
  }
  return out;
}

// The grooves or flats of a row: how often it goes from untouched to pressed.
int marks_in_row(const Carved& pot, int j) {
  int marks = 0;
  for (int i = 0; i < pot.clay().sectors(); ++i)
    marks += pot.outer(j, i) > 0.0549 && pot.outer(j, i + 1) <= 0.0549 ? 1 : 0;
  return marks;
}

TEST(Carving, AFacetIsFlatToAFiftiethOfAMillimetreOnEitherGrid) {
  for (const Grid grid : kGrids) {
    const Carved pot = carve("facet", grid);
    const int middle = pot.clay().first_row_above(0.11);
    EXPECT_EQ(marks_in_row(pot, middle), carving::kFacets) << grid.rows;
    const double deepest = 0.055 - carving::kFacetDeep;
    for (int n = 0; n < carving::kFacets; ++n) {
      const double facing = 0.35 + 2.0 * kPi * n / carving::kFacets;
      double worst = 0.0;
      // Within the rib's height, and the flat's width less an element.
      const double half = std::acos(deepest / 0.055) - 2.0 * kPi / grid.sectors;
      for (int j = pot.clay().first_row_above(0.07); pot.clay().row_height(j) < 0.15; ++j)
        for (int i = 0; i < grid.sectors; ++i) {
          const double off = std::remainder((i + 0.5) * 2.0 * kPi / grid.sectors - facing, 2 * kPi);
          if (std::fabs(off) > half) continue;
          worst = std::max(worst, std::fabs(pot.outer(j, i) * std::cos(off) - deepest));
        }
      EXPECT_LT(worst, 2e-5) << grid.rows << " facet " << n;
    }
  }
}

TEST(Carving, ThereAreTwelveFlutesEachWhereItWasDrawnAndAsDeep) {
  for (const Grid grid : kGrids) {
    const Carved pot = carve("flute", grid);
    for (double height : {0.05, 0.10, 0.15}) {
      const int j = pot.clay().first_row_above(height);
      EXPECT_EQ(marks_in_row(pot, j), carving::kFlutes) << grid.rows << ' ' << height;
      for (int n = 0; n < carving::kFlutes; ++n) {
        const double turns = 0.35 / (2.0 * kPi) + 1.0 * n / carving::kFlutes;
        const int i = static_cast<int>(std::floor(turns * grid.sectors));
        int deepest = i;
        for (int k = -grid.sectors / 30; k <= grid.sectors / 30; ++k)
          if (pot.outer(j, i + k) < pot.outer(j, deepest)) deepest = i + k;
        EXPECT_LE(std::abs(deepest - i), 1) << n;
        EXPECT_NEAR(pot.outer(j, deepest), 0.055 - carving::kFluteDeep, 3e-5) << n;
      }
    }
    // Above and below nothing is touched.
    EXPECT_EQ(marks_in_row(pot, pot.clay().first_row_above(0.02)), 0);
    EXPECT_EQ(marks_in_row(pot, pot.clay().first_row_above(0.19)), 0);
  }
}

TEST(Carving, AnIncisedLineIsWithinAnElementOfWhereItWasDrawn) {
  for (const Grid grid : kGrids) {
    const Carved pot = carve("incise", grid);
    const Clay& clay = pot.clay();
    const double row = clay.row_thickness(0);
    // Along every fifth ray the line crosses twice or more, a rise apart, each time a groove.
    for (int i = 0; i < grid.sectors; i += 5) {
      std::vector<double> crossings;
      for (int j = clay.first_row_above(0.065); clay.row_height(j) < 0.095; ++j) {
        const bool least = pot.outer(j, i) < 0.0546 && pot.outer(j, i) <= pot.outer(j - 1, i) &&
                           pot.outer(j, i) < pot.outer(j + 1, i);
        if (least) crossings.push_back(clay.row_height(j));
      }
      ASSERT_GE(crossings.size(), 2u) << grid.rows << " ray " << i;
      for (std::size_t n = 1; n < crossings.size(); ++n)
        EXPECT_NEAR(crossings[n] - crossings[n - 1], carving::kLineRise, 1.01 * row) << i;
    }
    // From ray to ray it rises as it winds; clay turns against the hand.
    int lines = 0;
    double deepest = 1.0;
    for (int j = clay.first_row_above(0.06); clay.row_height(j) < 0.097; ++j) {
      deepest = std::min(deepest, pot.outer(j, 0));
      lines += pot.outer(j, 0) < 0.0546 && pot.outer(j - 1, 0) >= 0.0546 ? 1 : 0;
    }
    EXPECT_GE(lines, 3) << grid.rows;
    EXPECT_NEAR(deepest, 0.055 - carving::kLineDeep, 1.5e-4) << grid.rows;
  }
}

TEST(Carving, TrimmingTakesTheFootInAndLeavesTheRest) {
  for (const Grid grid : kGrids) {
    const Carved pot = carve("trim_foot", grid);
    const int foot = pot.clay().first_row_above(0.008);
    const int wall = pot.clay().first_row_above(0.05);
    for (int i = 0; i < grid.sectors; ++i) {
      ASSERT_NEAR(pot.outer(foot, i), 0.055 - carving::kFootDeep, 1.5e-4) << i;
      EXPECT_FLOAT_EQ(static_cast<float>(pot.outer(wall, i)), 0.055f);
    }
  }
}

TEST(Carving, CutOffLeavesThePotFree) {
  const Carved pot = carve("cut_off", kGrids[0]);
  EXPECT_EQ(pot.last.cut_free, 1.0);
}

TEST(Carving, WithoutItsToolAScriptSaysWhatIsMissing) {
  SceneDef def;
  std::erase_if(def.tools, [](const SceneTool& tool) { return tool.name == "needle"; });
  const auto script = make_script("incise", {.scene = def});
  ASSERT_FALSE(script);
  EXPECT_NE(script.error().what.find("needle"), std::string::npos);
  EXPECT_TRUE(make_script("flute", {.scene = def}));
}

}  // namespace
}  // namespace onggi::carving_test
