#include "kiosk/exhibit/composition/ways.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::exhibit::ways_test {
namespace {

TEST(Ways, EveryVesselOfTheShelfNamesOneThatIsThereAndGlazesThatAre) {
  const WaysRead read = read_ways("content/ways");
  EXPECT_TRUE(read.problems.empty());
  EXPECT_TRUE(read.ways.contains(kUsualWay));
  std::vector<std::string> ways;
  for (const auto& [id, way] : read.ways) ways.push_back(id);
  const std::vector<std::string> vessels{"moon_jar", "maebyeong", "lekythos"};
  EXPECT_TRUE(unknown_ways("content/vessels", vessels, ways, {"celadon", "white_porcelain", "bare"})
                  .empty());
  std::erase(ways, "celadon");
  const auto problems =
      unknown_ways("content/vessels", vessels, ways, {"celadon", "white_porcelain"});
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_EQ(problems[0].what, "There is no way \"celadon\".");
  EXPECT_NE(problems[0].where.find("maebyeong/vessel.toml:"), std::string::npos);
  EXPECT_EQ(problems[1].what, "There is no glaze \"bare\".");
}

TEST(Ways, AVesselWithoutAWayNeedsTheUsualOne) {
  const files::test::ScratchFolder scratch;
  const std::filesystem::path shelf = scratch.path();
  std::filesystem::create_directories(shelf / "olla");
  std::ofstream(shelf / "olla" / "vessel.toml") << "height = 0.1\n";
  EXPECT_TRUE(unknown_ways(shelf, {"olla"}, {"celadon", kUsualWay}, {}).empty());
  const auto problems = unknown_ways(shelf, {"olla"}, {"celadon"}, {});
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].what, "It names no way, and there is no \"slip_painted\".");
  EXPECT_NE(problems[0].where.find("olla/vessel.toml"), std::string::npos);
}

TEST(Ways, OneThatIsNotThereIsSaidAndTheUsualOneTaken) {
  std::map<std::string, decoration::Way> ways;
  ways["celadon"].id = "celadon";
  ways[kUsualWay].id = kUsualWay;
  const WayFound good = find_way(ways, "celadon", "jar");
  EXPECT_EQ(good.way->id, "celadon");
  EXPECT_FALSE(good.problem);
  EXPECT_EQ(find_way(ways, "", "jar").way->id, kUsualWay);
  EXPECT_FALSE(find_way(ways, "", "jar").problem);
  const WayFound wrong = find_way(ways, "seladon", "jar");
  EXPECT_EQ(wrong.way->id, kUsualWay);
  ASSERT_TRUE(wrong.problem);
  EXPECT_EQ(wrong.problem->where, "the vessel jar");
  EXPECT_EQ(wrong.problem->what,
            "There is no good way \"seladon\". It is decorated by \"slip_painted\".");
  EXPECT_NE(wrong.problem->remedy.find("Did you mean \"celadon\"?"), std::string::npos);
  ways.erase(kUsualWay);
  EXPECT_EQ(find_way(ways, "", "jar").way, nullptr);
  ASSERT_TRUE(find_way(ways, "", "jar").problem);
  EXPECT_EQ(find_way(ways, "", "jar").problem->what,
            "It names no way, and there is no good \"slip_painted\". It stays plain.");
}

TEST(Ways, AFolderThatIsNotThereHasNone) { EXPECT_TRUE(read_ways("content/no_ways").ways.empty()); }

}  // namespace
}  // namespace onggi::exhibit::ways_test
