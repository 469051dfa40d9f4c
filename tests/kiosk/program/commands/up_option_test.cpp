#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "kiosk/collection/content/pack.h"
#include "tests/kiosk/program/commands/program.h"

namespace onggi::commands::up_option_test {
namespace {

nlohmann::json inspected(const std::string& more) {
  const Outcome run = onggi("vessel inspect --json - content/vessels/maebyeong" + more);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return run.exit_code == 0 ? nlohmann::json::parse(run.out) : nlohmann::json();
}

TEST(Up, standsAVesselOnItsHeadWhereThatIsAsked) {
  const auto found = inspected(""), turned = inspected(" --up=-y"), same = inspected(" --up y");
  EXPECT_EQ(turned["up_from"], "given");
  EXPECT_EQ(turned["up_sure"], 1.0);
  EXPECT_NEAR(turned["up"][1].get<double>(), -1.0, 1e-6);
  const auto foot = [](const nlohmann::json& report) {
    return report["outer"].front()[1].get<double>();
  };
  EXPECT_NEAR(foot(turned), found["outer"].back()[1].get<double>(),
              0.004);  // it stands on its mouth
  EXPECT_NEAR(foot(same), foot(found), 1e-6);
}

TEST(Up, goesBeforeWhatThePackSaysAndIsWrittenByImport) {
  ScratchFolder folder;
  const std::string shelf = (folder / "").string();
  const std::string import = "vessel import content/vessels/maebyeong/vessel.glb --shelf " + shelf;
  const Outcome run = onggi(import + " --id head --up=-y");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string toml = content(folder / "head/vessel.toml");
  EXPECT_NE(toml.find("\nup = \"-y\"\n"), std::string::npos) << toml;
  const Outcome head = onggi("vessel inspect --json - " + (folder / "head").string());
  EXPECT_EQ(nlohmann::json::parse(head.out)["up"][1], -1.0);
  const Outcome feet = onggi("vessel inspect --json - --up y " + (folder / "head").string());
  EXPECT_EQ(nlohmann::json::parse(feet.out)["up"][1], 1.0);
}

TEST(Up, isOneOfSixWordsAndAnyOtherIsToldWithARemedy) {
  for (const char* word : {"x", "y", "z", "-x", "-y", "-z"})
    EXPECT_TRUE(content::axis_called(word));
  for (const char* word : {"", "-", "w", "+y", "--y", "yy", "-yz"})
    EXPECT_FALSE(content::axis_called(word)) << word;
  const Outcome run = onggi("vessel inspect content/vessels/maebyeong --up north");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("--up north: "), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("=-z"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace onggi::commands::up_option_test
