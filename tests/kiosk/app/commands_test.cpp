#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/kiosk/app/program.h"

namespace onggi::app {
namespace {

TEST(Commands, EveryCommandHasHelpWithAnExample) {
  for (const char* command :
       {"", "run", "visit", "replay", "check", "vessel", "vessel make", "vessel inspect", "soak"}) {
    const Outcome run = onggi(std::string(command) + " --help");
    EXPECT_EQ(run.exit_code, 0) << command;
    EXPECT_NE(run.out.find("Example: onggi"), std::string::npos) << command;
  }
}

TEST(Commands, TheVersionIsAWordAndANumber) {
  const Outcome run = onggi("--version");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out.rfind("onggi ", 0), 0u) << run.out;
}

TEST(Commands, AWrongOptionIsTheInputsFault) {
  for (const char* wrong :
       {"--windw 1x1", "bogus", "visit", "run --window 10", "replay /nowhere", "check /nowhere",
        "vessel inspect /nowhere", "vessel make /nowhere.toml"}) {
    const Outcome run = onggi(wrong);
    EXPECT_EQ(run.exit_code, 2) << wrong;
    EXPECT_FALSE(run.err.empty()) << wrong;
    EXPECT_EQ(run.out, "") << wrong;
  }
}

TEST(Commands, WithoutADisplayTheKioskSaysWhatItLacks) {
  const Outcome run = onggi("run");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("isplay"), std::string::npos) << run.err;
}

TEST(Check, TheExhibitThatComesWithTheProgramIsGood) {
  const Outcome run = onggi("check");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out.rfind("All good: checked ", 0), 0u) << run.out;
}

TEST(Check, EverySlipOfAnExhibitIsNamedAtOnceWithLineColumnAndRemedy) {
  const TemporaryFolder folder;
  const std::string file = (folder / "exhibit.toml").string();
  std::ofstream(file) << "credits = \"Museum\"\n[idle]\ncountdown = 5\nwarn_after = \"soon\"\n";
  const Outcome run = onggi("check " + file);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find(file + ":1:1"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("credit"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find(file + ":3:"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find(file + ":4:"), std::string::npos) << run.err;
}

TEST(Check, WhereThereIsNothingToCheckIsNotGood) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "empty");
  const Outcome run = onggi("check " + (folder / "empty").string());
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("no vessel"), std::string::npos) << run.err;
}

TEST(Vessel, ADrawingBecomesAGlbThatMeasuresAsDrawn) {
  const TemporaryFolder folder;
  const std::string glb = (folder / "vessel.glb").string();
  const Outcome make = onggi("vessel make content/vessels/moon_jar/profile.toml -o " + glb);
  ASSERT_EQ(make.exit_code, 0) << make.err;
  EXPECT_EQ(text_of(glb), text_of("content/vessels/moon_jar/vessel.glb"));
  const Outcome inspect = onggi("vessel inspect --json - " + glb);
  ASSERT_EQ(inspect.exit_code, 0) << inspect.err;
  EXPECT_NEAR(nlohmann::json::parse(inspect.out)["height_m"].get<double>(), 0.305, 0.003);
}

TEST(Replay, AFileThatIsNoReplayIsRefusedWithAMeaning) {
  const TemporaryFolder folder;
  const std::string file = (folder / "visit.onggi").string();
  std::ofstream(file) << "not a replay at all";
  const Outcome run = onggi("replay " + file);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find(file), std::string::npos);
}

}  // namespace
}  // namespace onggi::app
