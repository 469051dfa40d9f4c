#include "kiosk/visit/decorating/beaten_wall.h"

#include <gtest/gtest.h>

#include "engine/math/portable.h"
#include "tests/kiosk/visit/decorating/decorating.h"

namespace onggi::decorating::beaten_wall_test {
namespace {

Print struck(Print::Kind kind, WallSide side, double height, double angle) {
  Print print;
  print.kind = kind;
  print.side = side;
  print.low = height - 0.02, print.high = height + 0.02;
  print.angle = angle;
  print.half = 0.3;
  print.wide = print.tall = 0.02;
  print.deep = 0.002;
  return print;
}

PrintsDef faces(int paddle, double rings = 0.004) {
  PrintsDef def;
  def.paddle = paddle;
  def.rings = rings;
  return def;
}

// Of the row at `height` on one side, the deepest relief round the pot within `half` of `angle`.
int deepest(const surface::Surface& surface, bool inside, double height, double angle,
            double half) {
  const auto part = inside ? surface::Part::inside : surface::Part::outside;
  int found = 0;
  for (int j = 0; j < surface.rows(); ++j) {
    if (surface.row(j).part != part || std::abs(surface.row(j).height - height) > 0.003) continue;
    for (int i = 0; i < surface::kSectors; ++i) {
      const double off = 2.0 * portable::kPi * i / surface::kSectors - angle;
      if (std::cos(off) >= std::cos(half)) found = std::min(found, surface.relief(j, i));
    }
  }
  return found;
}

struct Printed : Decorating {
  const std::vector<Print> blow{struck(Print::paddle, WallSide::outside, 0.08, 1.0),
                                struck(Print::anvil, WallSide::inside, 0.08, 1.0)};
  std::unique_ptr<DecoratedPot> with(const PrintsDef& def) {
    return *DecoratedPot::begin(a_jar(), way, blow, def);
  }
};

TEST_F(Printed, APaddleIsSeenOutsideAndItsAnvilInsideWhereTheBlowFell) {
  for (const int face : {PrintsDef::cord, PrintsDef::grid}) {
    const auto printed = with(faces(face));
    EXPECT_TRUE(printed->printed());
    EXPECT_TRUE(printed->bare()) << "the visitor has not done anything yet";
    EXPECT_FALSE(printed->plain());
    for (const bool inside : {false, true}) {
      EXPECT_LT(deepest(printed->surface(), inside, 0.08, 1.0, 0.2), -350);
      EXPECT_EQ(deepest(printed->surface(), inside, 0.08, 1.0 + portable::kPi, 2.6), 0);
      EXPECT_EQ(deepest(printed->surface(), inside, 0.12, 1.0, 1.0), 0);
    }
  }
}

TEST_F(Printed, PlainWoodLeavesNothingOutsideAndWithASmoothAnvilThePotIsPlain) {
  const auto rings = with(faces(PrintsDef::plain));
  EXPECT_TRUE(rings->printed());
  EXPECT_EQ(deepest(rings->surface(), false, 0.08, 1.0, 0.2), 0);
  EXPECT_LT(deepest(rings->surface(), true, 0.08, 1.0, 0.2), -350);
  const auto plain = with(faces(PrintsDef::plain, 0.0));
  EXPECT_FALSE(plain->printed());
  EXPECT_TRUE(plain->plain());
  EXPECT_EQ(plain->surface().hash(), pot->surface().hash());
  EXPECT_EQ(plain->surface().bytes(), pot->surface().bytes());
}

TEST_F(Printed, ThePictureShowsItFromTheFirstFrame) {
  pot = with(faces(PrintsDef::grid));
  EXPECT_TRUE(pot->settled());
  const auto form = pot->picture().form();
  expect_whole_picture();
  EXPECT_TRUE(form == pot->picture().form());
}

TEST_F(Printed, WhatIsDrawnOverItIsTakenBackAndThePrintStays) {
  pot = with(faces(PrintsDef::cord));
  const std::uint64_t before = pot->surface().hash();
  EXPECT_FALSE(pot->can_undo());
  touch(cut, 0.08, 1.0 / (2.0 * portable::kPi));
  EXPECT_FALSE(pot->bare());
  EXPECT_NE(pot->surface().hash(), before);
  pot->undo();
  EXPECT_EQ(pot->surface().hash(), before);
  EXPECT_FALSE(pot->plain());
}

TEST_F(Printed, AHandThatSmoothedTheWallIsLikePlainWood) {
  std::vector<Print> prints{blow[0]};
  Print hand = struck(Print::smoothed, WallSide::outside, 0.08, 1.0);
  hand.half = portable::kPi;
  prints.push_back(hand);
  const auto smooth = *DecoratedPot::begin(a_jar(), way, prints, faces(PrintsDef::grid));
  EXPECT_EQ(deepest(smooth->surface(), false, 0.08, 1.0, 0.3), 0);
}

// The visitor is at +z. The handle goes from a high blow down to the elbow, and cords lie across
// it.
TEST_F(Printed, AboveTheElbowACordGoesUpTowardsTheVisitorOnBothSidesAndBelowItAway) {
  // How far (cells) a groove goes towards +z while it goes up by 3 mm: where the rows look most
  // alike.
  const auto towards_visitor = [&](double height, bool left) {
    Print one = struck(Print::paddle, WallSide::outside, height, left ? portable::kPi : 0.0);
    one.left = left;
    const auto printed = *DecoratedPot::begin(a_jar(), way, {&one, 1}, faces(PrintsDef::cord));
    const auto& surface = printed->surface();
    int j = 0;
    while (surface.row(j).height < height) ++j;
    const int middle = left ? surface::kSectors / 2 : 0;
    int best = 0, least = 1 << 30;
    for (int shift = -6; shift <= 6; ++shift) {
      int apart = 0;
      for (int i = middle - 25; i < middle + 25; ++i)
        apart += std::abs(surface.relief(j - 6, surface::wrapped(i)) -
                          surface.relief(j + 6, surface::wrapped(i + shift)));
      if (apart < least) least = apart, best = shift;
    }
    return left ? -best : best;
  };
  for (const bool left : {false, true}) {
    EXPECT_GT(towards_visitor(0.14, left), 1) << left;
    EXPECT_LT(towards_visitor(0.03, left), 0) << left;
  }
}

}  // namespace
}  // namespace onggi::decorating::beaten_wall_test
