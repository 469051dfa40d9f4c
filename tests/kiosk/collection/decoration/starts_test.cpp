#include "kiosk/collection/decoration/starts.h"

#include <gtest/gtest.h>

#include <cmath>

namespace onggi::decoration::starts_test {
namespace {

std::vector<Start> of(const std::string& vessel) {
  const auto decoration = read_decoration("content/vessels/" + vessel + "/decoration.toml");
  EXPECT_TRUE(decoration) << (decoration ? "" : to_text(decoration.error()));
  return decoration ? starts_of(*decoration, 0.3) : std::vector<Start>{};
}

TEST(Starts, AZoneHasOneStartHoweverManyStepsItHas) {
  const auto starts = of("albarello");
  int rings = 0, figures = 0;
  for (const Start& start : starts) (start.ring ? rings : figures)++;
  // Four pairs of lines and two more at the rim; shields, vines and lotus.
  EXPECT_GE(rings, 4);
  EXPECT_LE(rings, 8);
  EXPECT_EQ(figures, 4);
  for (const Start& one : starts)
    for (const Start& other : starts)
      if (&one != &other && one.ring == other.ring && one.inside == other.inside) {
        EXPECT_GT(std::abs(one.at - other.at), 0.03);
      }
}

TEST(Starts, AFigureIsHintedByAShortStrokeThatIsNotTheFigure) {
  for (const char* vessel : {"albarello", "olla", "maebyeong", "onggi"})
    for (const Start& start : of(vessel)) {
      if (start.ring) continue;
      const double way = std::hypot(start.to.x - start.from.x, start.to.y - start.from.y);
      EXPECT_GT(way, 0.0) << vessel;
      EXPECT_LT(way, 0.5 * start.reach) << vessel;
      EXPECT_GE(start.repeats, 2) << vessel;
      EXPECT_LE(start.repeats, 24) << vessel;
    }
}

TEST(Starts, ScenesThatStandAloneGiveNone) {
  for (const Start& start : of("lekythos")) EXPECT_TRUE(start.ring || start.repeats >= 2);
  EXPECT_FALSE(of("lekythos").empty());
}

TEST(Starts, WhatIsWithinABowlIsSaidSo) {
  bool inside = false;
  for (const Start& start : of("samanid_bowl")) inside = inside || start.inside;
  EXPECT_TRUE(inside);
}

}  // namespace
}  // namespace onggi::decoration::starts_test
