#include "kiosk/visit/screens/onward.h"

#include <gtest/gtest.h>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::onward_test {
namespace {

/// A shelf from easy to hard: the wider a jar's belly, the farther its wall leans.
struct Shelf {
  Shelf() {
    const double bellies[] = {0.05, 0.09, 0.14};
    for (std::size_t i = 0; i < 3; ++i) v.shelf[i].target = jar(bellies[i]);
    world.languages = &v.languages;
    world.shelf = &v.shelf;
    world.missions = &v.missions;
  }
  std::optional<Onward> after(int card, int stars, int mission = -1) {
    Desk desk(world);
    desk.card = card;
    desk.mission = mission;
    desk.score.stars = stars;
    return onward_from(desk);
  }
  Visitor v{3};
  VisitInputs world;
};

TEST(Onward, AGoodPotLeadsToTheNextHarderVesselAndAPoorOneToTheNextEasier) {
  Shelf shelf;
  for (const int stars : {4, 5}) {
    const auto on = shelf.after(0, stars);
    ASSERT_TRUE(on);
    EXPECT_EQ(on->of.card, 1) << "the next one, not the hardest";
    EXPECT_EQ(on->key, "result.harder");
  }
  for (const int stars : {1, 2}) {
    const auto on = shelf.after(2, stars);
    ASSERT_TRUE(on);
    EXPECT_EQ(on->of.card, 1);
    EXPECT_EQ(on->key, "result.easier");
  }
  EXPECT_FALSE(shelf.after(1, 3)) << "the same one again is the next step";
  EXPECT_FALSE(shelf.after(0, 1)) << "there is no easier one";
  EXPECT_FALSE(shelf.after(2, 5)) << "there is no harder one, and no mission";
}

TEST(Onward, TheHardestLeadsToAMissionAndAMissionToTheNext) {
  Shelf shelf;
  shelf.v.put_on(Visitor::described(1));
  shelf.v.put_on(Visitor::described(2));
  const auto first = shelf.after(2, 5);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->of.mission, 0);
  const auto second = shelf.after(own_card(0), 4, 0);
  ASSERT_TRUE(second);
  EXPECT_EQ(second->of.mission, 1);
  EXPECT_EQ(second->of.card, own_card(1));
  EXPECT_FALSE(shelf.after(own_card(1), 4, 1));
  EXPECT_FALSE(shelf.after(own_card(0), 1, 0));
}

TEST(Onward, TheButtonSaysItsNameAndOpensItsLabel) {
  Visitor v(3);
  for (std::size_t i = 0; i < 3; ++i) {
    v.shelf[i].target = jar(0.14 - 0.04 * static_cast<double>(i));
    v.vessels[i].labels["en"].title = "Vessel " + std::to_string(i);
  }
  v.make_result();
  v.frames(1);
  ASSERT_LE(v.visit->score().stars, 2) << "an untouched lump";
  EXPECT_NE(words_in(v.frame).find("easier one: Vessel 1"), std::string::npos) << words_in(v.frame);
  v.touch("result.onward");
  v.touch("leaving.go");
  v.frames(1);
  ASSERT_EQ(v.visit->screen(), ScreenId::choose);
  ASSERT_TRUE(v.visit->control("choose.throw"));
  EXPECT_NE(words_in(v.frame).find("Vessel 1"), std::string::npos);
  v.touch("back");
  v.frames(1);
  EXPECT_TRUE(v.visit->control("choose.card.0")) << "Back leads to the shelf";
  v.touch("choose.card.2");
  v.touch("choose.throw");
  v.touch("throw.done");
  v.touch("result.other");
  v.touch("leaving.go");
  v.frames(1);
  EXPECT_TRUE(v.visit->control("choose.card.0")) << "an old offer opens nothing";
}

}  // namespace
}  // namespace onggi::screens::onward_test
