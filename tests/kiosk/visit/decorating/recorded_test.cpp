#include "kiosk/visit/decorating/recorded.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <string>

#include "kiosk/collection/decoration/decorate.h"
#include "kiosk/collection/decoration/write_decoration.h"
#include "tests/kiosk/ground/files/scratch_folder.h"
#include "tests/kiosk/visit/decorating/a_jar.h"
#include "tests/kiosk/visit/decorating/every_tool.h"

namespace onggi::decorating::recorded_test {
namespace {

using decoration::Decoration;
using decoration::Step;
using decoration::WayTool;
using surface::kRowHeight;
using surface::kSectors;

/// The real vessel: 240 mm, which the wheel has at 200.
Profile tall_jar() { return scaled(a_jar(), 1.5); }

/// A pot of the vessel's outline that notes what is done on it.
std::unique_ptr<DecoratedPot> begun(const decoration::Way& way) {
  auto pot = *DecoratedPot::begin(scaled(tall_jar(), decoration::wheel_scale(tall_jar())), way);
  pot->keep_work();
  return pot;
}

Decoration record(const DecoratedPot& pot) {
  Decoration out = recorded(pot, decoration::wheel_scale(tall_jar()));
  out.sources = "a \"book\"\\\n of the museum", out.simplified = "nothing";
  return out;
}

Decoration written_and_read(const Decoration& decoration) {
  const files::test::ScratchFolder folder;
  const std::string file = folder / "decoration.toml";
  std::ofstream(file) << decoration::to_toml(decoration);
  const auto read = decoration::check_decoration(file);
  EXPECT_TRUE(read.problems.empty())
      << to_text(read.problems.front()) << decoration::to_toml(decoration);
  return read.decoration;
}

surface::Surface done(const Decoration& decoration) {
  auto surface = decoration::decorated(tall_jar(), decoration, "jar");
  EXPECT_TRUE(surface) << (surface ? "" : to_text(surface.error()));
  return std::move(*surface);
}

/// A hand that does with the held tool what it is for, somewhere.
void work(DecoratedPot& pot, std::mt19937& random) {
  const auto any = [&](double from, double to) {
    return from + (to - from) * (static_cast<double>(random() % 10000) / 1e4);
  };
  const bool inside = random() % 8 == 0;
  const double end = 1e-6 * pot.surface().rows() * kRowHeight;
  Place at{inside ? any(pot.outside() + 0.01, end - 0.05) : any(0.02, pot.outside() - 0.02),
           any(0.0, 1.0)};
  pot.press(at);
  const int moves = static_cast<int>(random() % 12);
  for (int n = 0; n < moves; ++n) {
    at.along += any(-0.006, 0.006), at.turns += any(-0.02, 0.03);
    pot.move(at);
  }
  pot.lift();
  pot.end_work();
}

/// True if a cell's uppermost colour, cut, glaze, smoke or polish is another.
bool differs(const surface::Surface& a, const surface::Surface& b, int j, int i) {
  return (a.slip(j, i).thickness() > 5000) != (b.slip(j, i).thickness() > 5000) ||
         std::abs(a.relief(j, i) - b.relief(j, i)) > 150 ||
         std::abs(a.glaze(j, i) - b.glaze(j, i)) > 25 ||
         std::abs(a.smoke(j, i) - b.smoke(j, i)) > 40 || a.burnish(j, i) != b.burnish(j, i);
}

/// How many cells are other than the hand left them, as a share of those that it changed.
double unlike(const surface::Surface& hand, const surface::Surface& bare,
              const surface::Surface& file) {
  double other = 0.0, changed = 0.0;
  for (int j = 0; j < hand.rows(); ++j)
    for (int i = 0; i < kSectors; ++i) {
      other += differs(hand, file, j, i);
      changed += differs(hand, bare, j, i);
    }
  return changed > 0.0 ? other / changed : 0.0;
}

std::vector<decoration::Way> all_ways() {
  std::vector<decoration::Way> ways;
  for (const auto& file : std::filesystem::directory_iterator("content/ways"))
    ways.push_back(decoration::read_way(file.path(), {"en"}).way);
  return ways;
}

TEST(Recorded, WhatEveryToolOfEveryWayDidComesBackFromItsFileToTheBit) {
  std::map<Step::Kind, int> kinds;
  for (const decoration::Way& way : all_ways()) {
    std::mt19937 random(1);
    auto pot = begun(way);
    for (int n = 0; n < 2; ++n)
      for (std::size_t tool = 0; tool < way.tools.size(); ++tool) {
        pot->choose_tool(static_cast<int>(tool));
        const WayTool& held = pot->held();
        if (!held.pigments.empty())
          pot->choose_pigment(static_cast<int>(random() % held.pigments.size()));
        if (!held.motifs.empty())
          pot->choose_figure(static_cast<int>(random() % held.motifs.size()));
        pot->choose_repeats(decoration::kRepeats[random() % std::size(decoration::kRepeats)]);
        work(*pot, random);
        if (random() % 5 == 0) pot->undo();
      }
    const Decoration direct = record(*pot);
    ASSERT_FALSE(direct.steps.empty());
    for (const Step& step : direct.steps) ++kinds[step.kind];
    const Decoration read = written_and_read(direct);
    ASSERT_EQ(read.steps.size(), direct.steps.size());
    EXPECT_EQ(done(read).hash(), done(direct).hash()) << way.id;
    EXPECT_EQ(decoration::to_toml(read), decoration::to_toml(direct)) << way.id;
    EXPECT_EQ(read.sources, direct.sources);
  }
  EXPECT_EQ(kinds.size(), decoration::kKindNames.size());
}

TEST(Recorded, ThePotOfTheFileLooksAsTheHandMadeIt) {
  for (const decoration::Way& way : all_ways())
    for (std::size_t tool = 0; tool < way.tools.size(); ++tool) {
      std::mt19937 random(7);
      auto pot = begun(way);
      for (int needed = way.tools[tool].needs; needed >= 0;
           needed = way.tools[static_cast<std::size_t>(needed)].needs) {
        pot->choose_tool(needed);
        work(*pot, random);
      }
      pot->choose_tool(static_cast<int>(tool));
      for (int n = 0; n < 3; ++n) work(*pot, random);
      EXPECT_LT(unlike(pot->surface(), begun(way)->surface(), done(record(*pot))), 0.1)
          << way.id << ", " << way.tools[tool].id;
    }
}

TEST(Recorded, UndoTakesTheStepBackAndAnExampleIsNone) {
  const decoration::Way way = every_tool();
  auto pot = begun(way);
  std::mt19937 random(1);
  pot->choose_tool(band);
  work(*pot, random);
  const std::string one = decoration::to_toml(record(*pot));
  pot->choose_tool(cut);
  work(*pot, random);
  EXPECT_NE(decoration::to_toml(record(*pot)), one);
  pot->undo();
  EXPECT_EQ(decoration::to_toml(record(*pot)), one);
  pot->begin_example();
  work(*pot, random);
  EXPECT_EQ(decoration::to_toml(record(*pot)), one);
  pot->end_example();
  EXPECT_EQ(decoration::to_toml(record(*pot)), one);
  pot->undo();
  EXPECT_TRUE(record(*pot).steps.empty());
}

TEST(Recorded, LinesOfOneToolThatFollowEachOtherAreOneMotif) {
  const decoration::Way way = every_tool();
  auto pot = begun(way);
  std::mt19937 random(3);
  const auto draw = [&](int tool, double along) {
    pot->choose_tool(tool);
    pot->press({along, 0.95});
    for (int n = 0; n < 8; ++n) pot->move({along + 0.002 * n, 0.95 + 0.01 * n});
    pot->lift();
    pot->end_work();
  };
  draw(cut, 0.05);
  draw(cut, 0.08);
  draw(band, 0.1);
  draw(cut, 0.1);
  const Decoration out = record(*pot);
  ASSERT_EQ(out.steps.size(), 3u);
  EXPECT_EQ(out.steps[0].motif.lines.size(), 2u);
  EXPECT_EQ(out.steps[0].repeat, 8);
  EXPECT_EQ(out.steps[1].kind, Step::band);
  EXPECT_EQ(out.steps[2].motif.lines.size(), 1u);
}

TEST(Recorded, OnlyThePigmentsThatWereTakenAreInTheFile) {
  const decoration::Way way = every_tool();
  auto pot = begun(way);
  std::mt19937 random(1);
  pot->choose_tool(band);
  pot->choose_pigment(1);
  work(*pot, random);
  const Decoration out = record(*pot);
  ASSERT_EQ(out.pigments.size(), 1u);
  EXPECT_EQ(out.pigments[0].id, "black");
  EXPECT_EQ(out.steps[0].pigment, 0);
}

}  // namespace
}  // namespace onggi::decorating::recorded_test
