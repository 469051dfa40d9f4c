#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/kiosk/collection/archives/zip_maker.h"
#include "tests/kiosk/program/commands/program.h"

// What the staff's page asks of onggi about a scan, a scene and their shelf: answers for programs.
namespace onggi::commands::scan_json_test {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

class AnswersForPrograms : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "shelf");
    fs::create_directories(folder_ / "scan");
    fs::copy("content/vessels/tea_bowl/vessel.glb", folder_ / "scan/bowl.glb");
  }
  static nlohmann::json answer_of(const Outcome& run) {
    EXPECT_NE(run.exit_code, 1) << run.err;
    return nlohmann::json::parse(run.out, nullptr, false);
  }
  nlohmann::json look() const {
    return answer_of(onggi("vessel look " + quoted(folder_ / "scan")));
  }
  ScratchFolder folder_;
};

TEST_F(AnswersForPrograms, AScanIsToldWithWhatIsSureOfIt) {
  const auto seen = look();
  ASSERT_EQ(seen["vessels"].size(), 1u);
  const auto& bowl = seen["vessels"][0];
  EXPECT_EQ(bowl["up_axis"], "y");
  EXPECT_EQ(bowl["down_axis"], "-y");
  EXPECT_EQ(bowl["up_is_sure"], true);
  EXPECT_EQ(bowl["size_is_sure"], true);
  EXPECT_EQ(bowl["inner"], "measured");
  EXPECT_GT(bowl["outer"].size(), 100u);
}

TEST_F(AnswersForPrograms, AnArchiveIsUnpackedBesideItOnceAndAScanWithAFaultHidesNoOther) {
  const std::string bowl = content("content/vessels/tea_bowl/vessel.glb");
  archives::test::write_zip(folder_ / "scan/set.zip",
                            archives::test::zip_of({{"a/jar.glb", bowl}, {"a/bad.glb", "glTF"}}));
  for (int n = 0; n < 2; ++n) {
    const auto seen = look();
    EXPECT_EQ(seen["vessels"].size(), 2u);
    ASSERT_EQ(seen["notes"].size(), 1u);
    EXPECT_THAT(seen["notes"][0].get<std::string>(), HasSubstr("bad.glb"));
  }
  fs::remove_all(folder_ / "scan");
  fs::create_directories(folder_ / "scan");
  std::ofstream(folder_ / "scan/notes.txt") << "no scan";
  EXPECT_EQ(look()["done"], false);
  EXPECT_THAT(look()["what"].get<std::string>(), HasSubstr("no scan"));
  std::ofstream(folder_ / "scan/x.zip") << "no archive";
  EXPECT_EQ(look()["done"], false);
}

TEST_F(AnswersForPrograms, AVesselIsPutOnTheShelfWithItsHeightAndTheOtherWayUp) {
  const std::string import = "vessel import " + quoted(folder_ / "scan/bowl.glb") +
                             " --json - --shelf " + quoted(folder_ / "shelf") + " --id ";
  EXPECT_EQ(answer_of(onggi(import + "bowl --up=-y --height=90.5"))["done"], true);
  const std::string toml = content(folder_ / "shelf/bowl/vessel.toml");
  EXPECT_THAT(toml, HasSubstr("\ntrue_height_mm = 90.5\n"));
  EXPECT_THAT(toml, HasSubstr("\nup = \"-y\"\n"));
  for (const char* wrong : {"bowl", "Bowl", "cup --height=3", "cup --height=5000", "cup --up=w"}) {
    const auto refused = answer_of(onggi(import + wrong));
    EXPECT_EQ(refused["done"], false) << wrong;
    EXPECT_FALSE(refused["remedy"].get<std::string>().empty()) << wrong;
  }
  EXPECT_FALSE(fs::exists(folder_ / "shelf/cup"));
}

TEST_F(AnswersForPrograms, AVesselStandsOnTheShelfWholeOrNotAtAll) {
  // A shape without its label would be shown to visitors, so nothing is there before both are.
  const fs::path left = folder_ / "shelf/.bowl.new";
  fs::create_directories(left);
  std::ofstream(left / "vessel.glb") << "of an import that was killed";
  const std::string import = "vessel import " + quoted(folder_ / "scan/bowl.glb") + " --shelf " +
                             quoted(folder_ / "shelf") + " --id bowl";
  const Outcome full = onggi(import, "ulimit -f 8");  // 4 KiB a file
  EXPECT_NE(full.exit_code, 0);
  EXPECT_TRUE(fs::is_empty(folder_ / "shelf") || fs::exists(left)) << "at most what is hidden";
  EXPECT_FALSE(fs::exists(folder_ / "shelf/bowl"));
  EXPECT_EQ(onggi(import).exit_code, 0);
  EXPECT_TRUE(fs::exists(folder_ / "shelf/bowl/vessel.toml"));
  EXPECT_FALSE(fs::exists(left));
}

TEST_F(AnswersForPrograms, AScenesPricesHaveEveryEffect) {
  std::ofstream(folder_ / "soft.toml") << "[clay]\nrows = 60\nsectors = 60\n[walls]\n[volume]\n";
  const auto run = onggi("lab prices --idle --json - " + quoted(folder_ / "soft.toml"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto prices = nlohmann::json::parse(run.out);
  EXPECT_GT(prices["whole_us"], 0.0);
  EXPECT_EQ(prices["effects"].size() + prices["offers"].size(), 12u);  // all but the kiln
  EXPECT_THAT(onggi("lab prices " + quoted(folder_ / "soft.toml")).out, HasSubstr("us more"));
  EXPECT_EQ(onggi("lab prices config/scenes/paper.toml").exit_code, 2);
}

}  // namespace
}  // namespace onggi::commands::scan_json_test
