#include "kiosk/exhibit/composition/missions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "engine/profile/capacity.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::exhibit::missions_test {
namespace {

class MissionsTest : public ::testing::Test {
 protected:
  MissionsTest() {
    exhibit.scene = "config/scenes/first_touch.toml";
    exhibit.glazes = "content/glazes.toml";
    exhibit.languages = {"en"};
    exhibit.missions = folder.path() / "missions.toml";
    for (const char* id : {"tea_bowl", "moon_jar", "albarello"}) vessels.emplace_back().id = id;
    for (const content::Vessel& one : vessels) shelf.push_back({&one, 0, {}, 1.0, {}});
  }
  void write(const std::string& kind, const std::string& id = "it") {
    std::ofstream(*exhibit.missions, std::ios::app)
        << "[[mission]]\nid = \"" << id << "\"\ntitle = { en = \"It\" }\nabout = { en = \"Do.\" }\n"
        << kind << "\n";
  }
  const std::string& thrown(const Missions& missions) const {
    return missions.card(missions.cards().at(0).card, shelf)->vessel->id;
  }

  files::test::ScratchFolder folder;
  settings::Exhibit exhibit;
  std::deque<content::Vessel> vessels;
  std::vector<screens::ShelfCard> shelf;
  std::time_t wall = 1'777'900'000;  // 2026-05-04, about noon in any museum
};

TEST_F(MissionsTest, TodaysIsOneADayInTheOrderThatIsWrittenWhicheverComesFirstOnTheShelf) {
  write("kind = \"today\"\nvessels = [\"albarello\", \"tea_bowl\"]");
  const Scenes scenes(exhibit);
  Missions missions(exhibit, scenes, [this] { return wall; });
  missions.look(shelf, true, false);
  const std::string first = thrown(missions);
  std::reverse(shelf.begin(), shelf.end());
  Missions elsewhere(exhibit, scenes, [this] { return wall; });
  elsewhere.look(shelf, true, false);
  EXPECT_EQ(thrown(elsewhere), first) << "the same on every kiosk";
  wall += 86400;
  elsewhere.look(shelf, true, false);
  EXPECT_EQ(thrown(elsewhere), first) << "not while somebody is here";
  elsewhere.look(shelf, true, true);
  EXPECT_NE(thrown(elsewhere), first);
  wall += 86400;
  elsewhere.look(shelf, true, true);
  EXPECT_EQ(thrown(elsewhere), first);
}

TEST(TodaysVessel, ComesOnceInARoundOfTheShelfOverMonthsAndLeapYears) {
  for (const auto& [year, month] : {std::pair{2026, 12}, {2028, 2}, {1969, 12}}) {
    std::set<std::size_t> seen;
    const int last = month == 2 ? 29 : 31;
    for (int n = 0; n < 4; ++n) seen.insert(of_the_day({year, month, last - n}, 7));
    const int next = month == 12 ? 1 : month + 1;
    for (int n = 1; n <= 3; ++n)
      seen.insert(of_the_day({month == 12 ? year + 1 : year, next, n}, 7));
    EXPECT_EQ(seen.size(), 7u) << year << '-' << month;
  }
  EXPECT_EQ(of_the_day({2026, 5, 4}, 1), 0u);
}

TEST_F(MissionsTest, ADescriptionHasAPotThatAnswersItAndIsNobodysVessel) {
  write("kind = \"describe\"\nlitres = 0.5");
  const Scenes scenes(exhibit);
  Missions missions(exhibit, scenes, [this] { return wall; });
  missions.look(shelf, false, true);
  EXPECT_TRUE(missions.cards().empty()) << "not before the whole shelf is there";
  missions.look(shelf, true, true);
  ASSERT_EQ(missions.cards().size(), 1u);
  const screens::MissionCard& card = missions.cards().front();
  EXPECT_EQ(screens::mission_of_own(card.card), 0);
  const screens::ShelfCard* own = missions.card(card.card, shelf);
  ASSERT_EQ(own, &card.own);
  EXPECT_NEAR(capacity(own->target) * 1000, 0.5, 0.0005);
  EXPECT_EQ(own->vessel->id, "it");
  EXPECT_EQ(own->vessel->label("en").title, "It");
  EXPECT_FALSE(own->vessel->mesh.triangles.empty());
  EXPECT_TRUE(own->wheel.kiln);
  EXPECT_EQ(missions.card(1, shelf), &shelf[1]);
  EXPECT_EQ(missions.card(-1, shelf), nullptr);
  EXPECT_EQ(missions.card(screens::own_card(1), shelf), nullptr);
}

TEST_F(MissionsTest, OneThatIsOffOrCannotBeIsNotThereAndTheOthersAre) {
  write("kind = \"today\"\non = false", "off");
  write("kind = \"describe\"\nlitres = 3\nheight_mm = [40, 45]", "cannot_be");
  write("kind = \"describe\"\nlitres = 1", "good");
  const Scenes scenes(exhibit);
  Missions missions(exhibit, scenes, [this] { return wall; });
  missions.look(shelf, true, true);
  ASSERT_EQ(missions.cards().size(), 1u);
  EXPECT_EQ(missions.cards()[0].mission->id, "good");
  EXPECT_EQ(screens::mission_of_own(missions.cards()[0].card), 0);
  Missions asked(
      exhibit, scenes, [this] { return wall; }, "off");
  asked.look(shelf, true, true);
  ASSERT_EQ(asked.cards().size(), 2u) << "a scripted visit may ask for one that is off";
  EXPECT_EQ(asked.cards()[0].mission->id, "off");
}

TEST_F(MissionsTest, OneThatIsOffAndAskedForIsNotThereWhereItsVesselIsNot) {
  write("kind = \"two_hands\"\non = false\nvessel = \"urn\"", "hands");
  write("kind = \"today\"\non = false\nvessels = [\"tea_bowl\", \"urn\"]", "today");
  const Scenes scenes(exhibit);
  for (const char* id : {"hands", "today"}) {
    Missions missions(
        exhibit, scenes, [this] { return wall; }, id);
    missions.look(shelf, true, true);
    EXPECT_TRUE(missions.cards().empty()) << id;
  }
}

TEST_F(MissionsTest, OneThatNeedsWhatIsNotThereIsOfferedOnceItIsAndNotBeforeSomebodysEyes) {
  write("kind = \"eyes_closed\"", "dark");
  write("kind = \"describe\"\nlitres = 1", "litre");
  write("kind = \"two_hands\"\nvessel = \"moon_jar\"", "two");
  write("kind = \"two_hands\"\nsecond = \"keys\"", "keys");
  const Scenes scenes(exhibit);
  Missions missions(exhibit, scenes, [this] { return wall; });
  const auto offered = [&] {
    std::string all;
    for (const screens::MissionCard& card : missions.cards()) all += card.mission->id + ' ';
    return all;
  };
  missions.look(shelf, true, true, {false, false});
  EXPECT_EQ(offered(), "litre keys ");
  EXPECT_EQ(screens::mission_of_own(missions.cards()[0].card), 0);
  missions.look(shelf, true, false, {true, true});
  EXPECT_EQ(offered(), "litre keys ");
  missions.look(shelf, true, true, {true, true});
  EXPECT_EQ(offered(), "dark litre two keys ");
  EXPECT_EQ(screens::mission_of_own(missions.cards()[1].card), 1) << "its own card goes along";
  EXPECT_EQ(missions.card(missions.cards()[1].card, shelf)->vessel->id, "litre");
  EXPECT_EQ(missions.card(missions.cards()[2].card, shelf)->vessel->id, "moon_jar");
  EXPECT_EQ(missions.cards()[0].card, 0) << "without a name the shelf's first";
  missions.look(shelf, true, true, {true, false});
  EXPECT_EQ(offered(), "dark litre keys ");
}

TEST_F(MissionsTest, WhyOneIsNotOfferedIsSaidWithARemedy) {
  settings::Mission one;
  one.kind = settings::Mission::Kind::eyes_closed;
  EXPECT_EQ(reason_unavailable(one, {true, false}), "");
  EXPECT_NE(reason_unavailable(one, {false, true}).find("[sound]"), std::string::npos);
  one.kind = settings::Mission::Kind::two_hands;
  EXPECT_EQ(reason_unavailable(one, {false, true}), "");
  EXPECT_NE(reason_unavailable(one, {true, false}).find("second = \"keys\""), std::string::npos);
}

}  // namespace
}  // namespace onggi::exhibit::missions_test
