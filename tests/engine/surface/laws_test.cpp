#include "engine/surface/laws.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "engine/math/portable.h"
#include "tests/engine/surface/random_strokes.h"

namespace onggi::surface_test::laws_test {
namespace {

/// Of the pot of TheSameStrokesLeaveTheSameBitsOnEveryMachine: any law that changes its result
/// changes it.
constexpr std::uint64_t kGolden = 0xfba03827456cf9de;

std::vector<Station> wavy(const Surface& surface) {
  Tracer tracer(surface, 0.06);
  for (int n = 0; n <= 60; ++n)
    tracer.go({0.025 + 0.006 * portable::sin(n * 0.25), 0.2 + n * 0.003, 0.4 + 0.01 * n, n * 0.1});
  tracer.lift();
  return tracer.stations();
}

/// Every law that follows a way.
std::vector<Tool> ways() {
  CutDef comb;
  comb.teeth = 3;
  CutDef sunk;
  sunk.section = CutDef::sunk, sunk.width = 0.003;
  BrushDef brush;
  brush.pigment = 4, brush.fill = 0.3;
  StampDef stamp;
  stamp.side = 2, stamp.picture = {255, 0, 100, 50};
  return {CutDef{},  comb,  sunk,        brush,        ScrapeDef{},
          WipeDef{}, stamp, ResistDef{}, BurnishDef{}, CoilDef{}};
}

/// And the one whose stations are corners.
std::vector<Tool> tools() {
  std::vector<Tool> all = ways();
  FillDef fill;
  fill.pigment = 3;
  all.emplace_back(fill);
  return all;
}

/// A pot on which each law finds something to do.
Surface busy() {
  Surface surface = made(bowl());
  done(surface, CutDef{}, straight(surface, {0.02, 0.2}, {0.03, 0.5}));
  BrushDef brush;
  brush.pigment = 1;
  done(surface, brush, straight(surface, {0.02, 0.1}, {0.03, 0.5}));
  DipDef dip = whole_dip();
  dip.from = 0.024;
  done(surface, dip);
  return surface;
}

TEST(Laws, AStrokeCutInTwoIsTheStroke) {
  const Surface before = busy();
  const std::vector<Station> way = wavy(before);
  for (const Tool& tool : ways()) {
    Surface whole = before;
    ASSERT_TRUE(apply(whole, {tool, way, false}));
    EXPECT_NE(whole.hash(), before.hash()) << tool.index();
    for (const std::size_t at : {std::size_t{1}, way.size() / 2, way.size() - 2}) {
      Surface halves = before;
      const auto middle = way.begin() + static_cast<std::ptrdiff_t>(at);
      ASSERT_TRUE(apply(halves, {tool, {way.begin(), middle + 1}, false}));
      ASSERT_TRUE(apply(halves, {tool, {middle, way.end()}, true}));
      EXPECT_EQ(halves.hash(), whole.hash()) << tool.index() << " cut at " << at;
      EXPECT_EQ(halves.steps(), whole.steps());
    }
  }
}

TEST(Laws, TurnedByWholeSectorsIsTheResultTurned) {
  const Surface bare = made(bowl());
  const std::vector<Station> way = wavy(bare);
  std::vector<Tool> all = tools();
  SmokeDef smoke;
  smoke.from = 0.03;
  all.push_back(smoke);
  for (const int sectors : {1, 333, kSectors - 7, -5}) {
    Surface here = bare, there = bare;
    done(here, whole_dip()), done(there, whole_dip());
    for (const Tool& tool : all) {
      const Stroke stroke{
          tool, std::holds_alternative<SmokeDef>(tool) ? std::vector<Station>{} : way, false};
      ASSERT_TRUE(apply(here, stroke));
      ASSERT_TRUE(apply(there, turned(stroke, sectors)));
    }
    expect_turned(here, there, sectors);
  }
}

TEST(Laws, AMotifRepeatedIsThatManyStrokesAndOneStepBack) {
  const Surface bare = made(bowl());
  for (const Tool& tool : tools()) {
    for (const int n : {2, 3, 5, 7, 8, 16}) {
      Surface together = bare, one_by_one = bare;
      const Stroke stroke{tool, wavy(bare), false};
      const auto all = repeated(stroke, n);
      ASSERT_TRUE(all);
      for (const Stroke& each : *all) ASSERT_TRUE(apply(together, each));
      for (int k = 0; k < n; ++k) ASSERT_TRUE(apply(one_by_one, turned(stroke, k * kSectors / n)));
      EXPECT_EQ(together.hash(), one_by_one.hash());
      EXPECT_EQ(together.steps(), 1);
      together.undo();
      EXPECT_EQ(together.hash(), bare.hash());
    }
  }
}

TEST(Laws, CutsRepeatedAreTheSameAtEachPlace) {
  Surface surface = made(bowl());
  CutDef def;
  def.burr = 0.0;
  const auto all = repeated({def, wavy(surface), false}, 8);
  ASSERT_TRUE(all);
  for (const Stroke& each : *all) ASSERT_TRUE(apply(surface, each));
  for (int j = 0; j < surface.rows(); ++j)
    for (int i = 0; i < kSectors; ++i)
      ASSERT_EQ(surface.relief(j, i), surface.relief(j, wrapped(i + kSectors / 8)));
}

TEST(Laws, TheSameStrokesLeaveTheSameBitsOnEveryMachine) {
  Surface surface = made(jar());
  RandomStrokes random(7);
  for (int n = 0; n < 300; ++n) ASSERT_TRUE(apply(surface, random.next(surface)));
  done(surface, whole_dip());
  SmokeDef smoke;
  smoke.from = 0.15;
  done(surface, smoke);
  EXPECT_EQ(surface.hash(), kGolden);
}

TEST(Laws, NoRandomStrokeBreaksAValueOrLosesSlipOrGlaze) {
  Surface surface = made(bowl());
  RandomStrokes random(1);
  struct Volumes {
    Volume slip = 0, glaze = 0;
  };
  Volumes is;
  std::vector<Volumes> was;  // before each step
  const auto check = [&] {
    ASSERT_EQ(all_slip(surface), is.slip);
    ASSERT_EQ(surface.glaze_volume(), is.glaze);
    ASSERT_LT(surface.bytes(), 32u << 20);
    expect_whole(surface);
  };
  const int strokes = random_strokes();
  for (int n = 0; n < strokes; ++n) {
    const Stroke stroke = random.next(surface);
    if (!stroke.continues || !surface.can_undo()) was.push_back(is);
    const Result<Work> work = apply(surface, stroke);
    ASSERT_TRUE(work) << n << ": " << to_text(work.error());
    is.slip += work->slip_laid - work->slip_taken;
    is.glaze += work->glaze_laid - work->glaze_taken;
    if (random.bits() % 16 == 0) {
      surface.undo();
      is = was.back();
      was.pop_back();
    }
    if (n % (strokes / 12 + 1) == 0) check();
    if (HasFatalFailure()) FAIL() << "after stroke " << n;
  }
  check();
}

TEST(Laws, TheEndsOfEveryRangeAreGoodAndBeyondThemIsOneProblem) {
  const Surface bare = made(bowl());
  const auto way = straight(bare, {0.02, 0.0}, {0.022, 0.01});
  for (const Tool& tool : tools()) {
    std::visit(
        [&](auto def) {
          using Def = decltype(def);
          each_field<Def>([&](const auto& field) {
            for (const double end : {field.least, field.most}) {
              Def at = def;
              at.*(field.value) =
                  static_cast<std::remove_cvref_t<decltype(at.*(field.value))>>(end);
              if constexpr (std::is_same_v<Def, StampDef>)
                at.picture.assign(static_cast<std::size_t>(at.side * at.side), 200);
              Surface surface = bare;
              const Result<Work> work = apply(surface, {at, way, false});
              EXPECT_TRUE(work) << to_text(work.error());
              expect_whole(surface);
            }
            if constexpr (!std::is_same_v<std::remove_cvref_t<decltype(def.*(field.value))>,
                                          bool>) {
              Def beyond = def;
              beyond.*(field.value) +=
                  static_cast<std::remove_cvref_t<decltype(def.*(field.value))>>(field.most + 1);
              Surface surface = bare;
              const Result<Work> work = apply(surface, {beyond, way, false});
              ASSERT_FALSE(work) << field.key;
              EXPECT_EQ(work.error().where, std::string(Def::kName) + "." + field.key);
              EXPECT_EQ(surface.hash(), bare.hash());
              EXPECT_FALSE(surface.can_undo());
            }
          });
        },
        tool);
  }
}

TEST(Laws, AFaultyStrokeSaysWhereAndWhatAndDoesNothing) {
  Surface surface = made(bowl());
  const std::uint64_t bare = surface.hash();
  const auto way = straight(surface, {0.02, 0.0}, {0.03, 0.0});
  const auto fault = [&](const Stroke& stroke) {
    const Result<Work> work = apply(surface, stroke);
    EXPECT_FALSE(work);
    return work ? std::string() : to_text(work.error());
  };
  const auto with = [&](const std::function<void(Station&)>& change) {
    Stroke stroke{CutDef{}, way, false};
    change(stroke.stations[3]);
    return stroke;
  };
  CutDef none;
  none.depth = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(
      fault({none, way, false}),
      "cut.depth: cut.depth is nan m, outside 0 to 0.003 m.\n  Write a number from 0 to 0.003 m.");
  EXPECT_EQ(fault({CutDef{}, {}, false}),
            "cut.stations: cut.stations are missing.\n  Give one at least.");
  EXPECT_EQ(fault({whole_dip(), way, false}),
            "dip.stations: dip.stations are given, but it is not a stroke along a way.\n  Leave "
            "them out.");
  EXPECT_EQ(fault({DipDef{}, {}, false}),
            "dip.to: dip.to is not above from, so nothing is under.\n  Make it larger than from.");
  StampDef stamp;
  stamp.side = 3;
  EXPECT_EQ(fault({stamp, way, false}),
            "stamp.picture: stamp.picture has 0 cells, not side x side.\n  Give 9 of them.");
  EXPECT_EQ(fault(with([](Station& at) { at.pressure = 1025; })),
            "stroke, station 4.pressure: stroke, station 4.pressure is 1025, outside 0 to 1024.\n"
            "  Write a number from 0 to 1024.");
  EXPECT_NE(fault(with([](Station& at) { at.along = -1; })), "");
  EXPECT_NE(fault(with([](Station& at) { at.round = 2'000'000'000; })), "");
  EXPECT_NE(fault(with([](Station& at) { at.load = 2000; })), "");
  EXPECT_NE(fault(with([](Station& at) { at.across_round = 0; })), "");
  EXPECT_NE(fault(with([](Station& at) { at.along += 4200; })), "");
  EXPECT_NE(fault(with([](Station& at) { at.round += kTurn; })), "");
  Stroke wide{FillDef{}, way, false};
  wide.stations.back().round = wide.stations[0].round + kTurn + 1;
  EXPECT_NE(fault(wide), "");
  EXPECT_EQ(surface.hash(), bare);
  EXPECT_FALSE(surface.can_undo());
  const auto nine = repeated({CutDef{}, way, false}, 9);
  ASSERT_FALSE(nine);
  EXPECT_EQ(to_text(nine.error()),
            "repeat: repeat is 9, which does not divide the pot evenly.\n"
            "  Choose 2 to 8, 10, 12, 14, 15 or 16.");
}

}  // namespace
}  // namespace onggi::surface_test::laws_test
