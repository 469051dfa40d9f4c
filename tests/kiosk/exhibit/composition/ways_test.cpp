#include "kiosk/exhibit/composition/ways.h"

#include <gtest/gtest.h>

namespace onggi::exhibit {
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

TEST(Ways, AFolderThatIsNotThereHasNone) { EXPECT_TRUE(read_ways("content/no_ways").ways.empty()); }

}  // namespace
}  // namespace onggi::exhibit
