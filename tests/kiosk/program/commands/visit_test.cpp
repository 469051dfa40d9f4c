#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/kiosk/program/commands/program.h"

namespace fs = std::filesystem;

namespace onggi::commands::visit_test {
namespace {

using Json = nlohmann::json;

/// Enough to choose from, where a test does not speak of the whole shelf.
const std::vector<std::string> kFew = {"cylinder_vase", "moon_jar", "tea_bowl"};

TEST(Visit, TheSameVisitTwiceLeavesTheSamePotAndEverythingAVisitorTakesHome) {
  const ScratchFolder folder;
  Json reports[2];
  for (int i = 0; i < 2; ++i) {
    const std::string out = (folder / std::to_string(i)).string();
    const Outcome run = onggi(
        "visit --script follow --vessel moon_jar --glaze tenmoku --seed 3 --window 1024x600 --json "
        "- "
        "--out " +
        out);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    reports[i] = Json::parse(run.out);
  }
  EXPECT_EQ(reports[0]["state_hash"], reports[1]["state_hash"]);
  EXPECT_EQ(reports[0]["score"], reports[1]["score"]);
  EXPECT_EQ(reports[0]["ticks"], reports[1]["ticks"]);
  EXPECT_GT(reports[0]["score"].get<double>(), 90.0);
  EXPECT_EQ(reports[0]["vessel"], "moon_jar");
  EXPECT_EQ(reports[0]["glaze"], "tenmoku");
  // Stoneware shrinks by an eighth.
  EXPECT_NEAR(reports[0]["height"].get<double>(), 0.875 * reports[0]["thrown_height"].get<double>(),
              1e-4);

  EXPECT_GE(reports[0]["screens"].size(), 6u);
  ASSERT_EQ(reports[0]["files"].size(), 4u) << "postcard, model, replay, and it turns";
  for (const char* list : {"screens", "files"})
    for (const Json& file : reports[0][list])
      EXPECT_GT(fs::file_size(file.get<std::string>()), 1000u) << file;

  // The glazed model and the picture that turns are drawn, and are the same to the byte.
  for (const std::size_t drawn : {1u, 3u}) {
    const auto bytes = [&](int i) {
      return content(reports[i]["files"][drawn].get<std::string>());
    };
    EXPECT_EQ(bytes(0), bytes(1)) << reports[0]["files"][drawn];
  }
  EXPECT_LT(fs::file_size(reports[0]["files"][3].get<std::string>()), 2'200'000u);
  std::uintmax_t folder_bytes = 0;
  for (const Json& file : reports[0]["files"])
    folder_bytes += fs::file_size(file.get<std::string>());
  EXPECT_LT(folder_bytes, 8'000'000u) << "a folder of keepsakes promises as much";

  // The replay that the visitor left throws the same pot in the engine alone.
  const Outcome replay = onggi("replay --json - " + reports[0]["files"][2].get<std::string>());
  EXPECT_EQ(replay.exit_code, 0) << replay.err;
  EXPECT_EQ(Json::parse(replay.out)["state_hash"], reports[0]["state_hash"]);
  EXPECT_EQ(Json::parse(replay.out)["glaze"], "tenmoku");
}

// In a scene whose clay goes on springing back by itself, so that a moment more makes another pot.
TEST(Visit, WhatTheReportSaysIsWhatTheKeptVisitScoresToTheBit) {
  const ScratchFolder folder;
  const std::string rubric = fs::current_path().string() + "/config/rubric.toml";
  const std::string file = write_exhibit(
      folder, "first_touch",
      "rubric = \"" + rubric + "\"\n[vessel_scenes]\nmoon_jar = \"soft.toml\"\n", kFew);
  std::ofstream(folder / "soft.toml") << "[clay]\nrows = 160\nsectors = 120\nwall_min = 0.002\n"
                                         "[springback]\nshare = 0.12\ntime = 10.0\n[kiln]\n";
  const Outcome run =
      onggi("visit --script follow --vessel moon_jar --seed 5 --no-screens --window 640x480 " +
            ("--config " + file) + " --json - --out " + (folder / "out").string());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json visit = Json::parse(run.out);
  const std::string kept = visit["files"][2].get<std::string>();
  const Outcome again =
      onggi("score content/vessels/moon_jar " + kept + " --rubric " + rubric + " --json -");
  ASSERT_EQ(again.exit_code, 0) << again.err;
  const Json score = Json::parse(again.out);
  EXPECT_GT(visit["score"].get<double>(), 90.0);
  EXPECT_EQ(visit["score"].get<double>(), score["score"].get<double>());
  EXPECT_EQ(visit["measures"], score["measures"]);
  const Outcome replay = onggi("replay --json - " + kept);
  EXPECT_EQ(Json::parse(replay.out)["state_hash"], visit["state_hash"]);
}

TEST(Visit, AVesselWithASceneOfItsOwnIsThrownInThatAndTheOthersInTheExhibits) {
  const ScratchFolder folder;
  const std::string file =
      write_exhibit(folder, "first_touch", "[vessel_scenes]\ntea_bowl = \"unfired.toml\"\n", kFew);
  std::ofstream(folder / "unfired.toml") << "[clay]\nrows = 200\nsectors = 180\n";
  for (const auto& [vessel, fired] : {std::pair{"tea_bowl", false}, {"moon_jar", true}}) {
    const Outcome run =
        onggi("visit --script groove --no-screens --window 640x480 --config " + file +
              " --vessel " + vessel + " --json - --out " + (folder / vessel).string());
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Json report = Json::parse(run.out);
    const double shrunk = report["height"].get<double>() / report["thrown_height"].get<double>();
    EXPECT_NEAR(shrunk, fired ? 0.875 : 1.0, 1e-4) << vessel;
    EXPECT_EQ(report["glaze"].get<std::string>().empty(), !fired) << vessel;
  }
}

// The keyboard of its first clay begins with a stroke, and leads nowhere.
TEST(Visit, AScriptVisitsAnExhibitThatIsReadAloudOrHasOneSwitch) {
  for (const char* key : {"spoken", "one_switch"}) {
    const ScratchFolder folder;
    const std::string file = write_exhibit(
        folder, "first_touch",
        std::string("[vessel_scenes]\nmoon_jar = \"unfired.toml\"\n[screen]\n") + key + " = true\n",
        kFew);
    std::ofstream(folder / "unfired.toml") << "[clay]\nrows = 200\nsectors = 180\n";
    const Outcome run =
        onggi("visit --script groove --vessel moon_jar --no-screens --window 640x480 --config " +
              file + " --json - --out " + (folder / "out").string());
    ASSERT_EQ(run.exit_code, 0) << key << ": " << run.err;
    EXPECT_FALSE(Json::parse(run.out)["files"].empty()) << key;
  }
}

// The script waited for ever, and the command with it.
TEST(Visit, OnAWheelThatCannotTurnItEndsWithAWordOfTheWheel) {
  const ScratchFolder folder;
  const std::string file =
      write_exhibit(folder, "first_touch", "[vessel_scenes]\nmoon_jar = \"still.toml\"\n", kFew);
  std::ofstream(folder / "still.toml")
      << "[clay]\nrows = 160\nsectors = 120\n[wheel]\nmax_speed = 0.0\n";
  const Outcome run =
      onggi("visit --script follow --no-screens --window 640x480 --vessel moon_jar --config " +
            file + " --out " + (folder / "out").string());
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("max_speed"), std::string::npos) << run.err;
}

// A finger so thin passes above the rim, where the script's coil would lie.
TEST(Visit, WhereTheScriptNeverTouchesTheClayItEndsWithAWordOfTheScript) {
  const ScratchFolder folder;
  const std::string file =
      write_exhibit(folder, "first_touch", "[vessel_scenes]\nmoon_jar = \"thin.toml\"\n", kFew);
  std::ofstream(folder / "thin.toml")
      << "[clay]\nrows = 160\nsectors = 120\n[tool]\nradius = 0.002\n";
  const Outcome run =
      onggi("visit --script coil_up --no-screens --window 640x480 --vessel moon_jar --config " +
            file + " --out " + (folder / "out").string());
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("never touched the clay"), std::string::npos) << run.err;
}

TEST(Visit, AVesselWithABuiltSceneIsBuiltOfCoilsAndThrownInItsOther) {
  const ScratchFolder folder;
  const std::string file =
      write_exhibit(folder, "first_touch", "built_scene = \"built.toml\"\n", kFew);
  std::ofstream(folder / "built.toml")
      << "[clay]\nrows = 200\nsectors = 60\n[volume]\n[building]\ncoil = 0.02\n[kiln]\n";
  double scores[2];
  for (const bool built : {false, true}) {
    const Outcome run =
        onggi(std::string("visit --script ") + (built ? "build" : "true") +
              " --no-screens --window 640x480 --vessel cylinder_vase --json - --config " + file +
              " --out " + (folder / (built ? "built" : "thrown")).string());
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Json visit = Json::parse(run.out);
    scores[built ? 1 : 0] = visit["score"].get<double>();
    const Outcome replay = onggi("replay --json - " + visit["files"][2].get<std::string>());
    EXPECT_EQ(Json::parse(replay.out)["state_hash"], visit["state_hash"]) << "coils and all";
    EXPECT_EQ(visit["measures"]["made"]["wall_mean"].get<double>() > 0.014, built)
        << "as thick as a coil";
  }
  EXPECT_GT(scores[1], 50.0);
}

/// An exhibit with the missions that come with onggi, and a scene whose pots are soon thrown.
std::string with_missions(const ScratchFolder& folder) {
  std::ofstream(folder / "coarse.toml") << "[clay]\nrows = 160\nsectors = 120\n[walls]\n";
  return write_exhibit(folder, "first_touch",
                       "missions = \"" + fs::current_path().string() +
                           "/content/missions.toml\"\n[vessel_scenes]\nlitre_jar = "
                           "\"coarse.toml\"\nmoon_jar = \"coarse.toml\"\n",
                       kFew);
}

TEST(Visit, AMissionIsChosenThrownAndScoredByWhatItAsksFor) {
  const ScratchFolder folder;
  const Outcome run = onggi("visit --mission litre_jar --no-screens --window 640x480 --config " +
                            with_missions(folder) + " --json - --out " + (folder / "out").string());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json visit = Json::parse(run.out);
  EXPECT_EQ(visit["mission"], "litre_jar");
  EXPECT_EQ(visit["vessel"], "litre_jar") << "what is taken home is called so";
  EXPECT_EQ(visit["asked"]["mission.holds"]["wanted"], 100);
  EXPECT_NEAR(visit["asked"]["mission.holds"]["litres"].get<int>(), 100, 15);
  EXPECT_GT(visit["score"].get<double>(), 80.0);
  EXPECT_GE(visit["files"].size(), 3u) << "postcard, model and replay";
}

TEST(Visit, WithEyesClosedThePotIsThrownUnseenAndTwoVisitorsThrowOneWithAHandEach) {
  const ScratchFolder folder;
  const std::string config = with_missions(folder);
  for (const char* mission : {"eyes_closed", "two_hands"}) {
    const Outcome run = onggi("visit --mission " + std::string(mission) +
                              " --no-screens --window 640x480 --config " + config +
                              " --json - --out " + (folder / mission).string());
    ASSERT_EQ(run.exit_code, 0) << mission << ": " << run.err;
    const Json visit = Json::parse(run.out);
    EXPECT_EQ(visit["mission"], mission);
    EXPECT_EQ(visit["vessel"], "moon_jar");
    EXPECT_GT(visit["score"].get<double>(), 60.0) << mission;
  }
}

TEST(Visit, AMissionIsDoneByWhoHasOneSwitchAndWhatWasSaidOfItIsWritten) {
  const ScratchFolder folder;
  const fs::path out = folder / "out";
  const Outcome run = onggi(
      "visit --mission litre_jar --pace 0.5 --script switch --no-screens --window 640x480 "
      "--language ko "
      "--config " +
      with_missions(folder) + " --json - --out " + out.string());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json visit = Json::parse(run.out);
  EXPECT_EQ(visit["mission"], "litre_jar");
  EXPECT_NEAR(visit["asked"]["mission.holds"]["litres"].get<int>(), 100, 10);
  // A switch is asked for by holding on after speech was: both are there.
  EXPECT_NE(content(out / "said.txt").find("1리터가 담기는 항아리"), std::string::npos);
}

TEST(Visit, AnUnknownMissionIsRefusedWithTheNearestRightNameAndSoAreAVesselAndAMissionAtOnce) {
  const ScratchFolder folder;
  const std::string out = " --out " + (folder / "out").string();
  const Outcome wrong = onggi("visit --mission litre_jra" + out);
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.err.find("Did you mean litre_jar?"), std::string::npos) << wrong.err;
  const Outcome both = onggi("visit --mission litre_jar --vessel moon_jar" + out);
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_EQ(onggi("visit" + out).exit_code, 2) << "nor neither";
}

TEST(Visit, APlaceThatCanBeNoFolderIsRefusedBeforeTheVisit) {
  const ScratchFolder folder;
  std::ofstream(folder / "file") << "in the way";
  for (const std::string& out : {(folder / "file").string(), std::string("''")}) {
    const Outcome run = onggi("visit --vessel moon_jar --out " + out);
    EXPECT_EQ(run.exit_code, 2) << out;
    EXPECT_NE(run.err.find("--out"), std::string::npos) << run.err;
  }
}

TEST(Visit, AFolderOfTheExhibitOrWithOtherThingsInItIsRefusedAndStaysAsItIs) {
  const ScratchFolder site;
  for (const char* part : {"config", "content"})
    fs::copy(part, site / part, fs::copy_options::recursive);
  fs::create_directories(site / "photos");
  std::ofstream(site / "photos/pots.txt") << "mine";
  fs::create_directories(site / "album/screens");
  std::ofstream(site / "album/screens/holiday.png") << "mine";
  const auto files = [&site] {
    const auto all = fs::recursive_directory_iterator(site.path());
    return std::distance(begin(all), end(all));
  };
  const auto before = files();
  for (const auto& [out, why] : {std::pair{"content/vessels", "belongs to the exhibit"},
                                 std::pair{"content/vessels/moon_jar", "belongs to the exhibit"},
                                 std::pair{"content/languages", "belongs to the exhibit"},
                                 std::pair{"config", "belongs to the exhibit"},
                                 std::pair{"photos", "pots.txt"}, std::pair{"album", "holiday.png"},
                                 std::pair{".", "Something else lies in this folder: album"},
                                 std::pair{"content/vessels/new", "belongs to the exhibit"}}) {
    const Outcome run =
        onggi("visit --vessel moon_jar --config " + (site / "config/exhibit.toml").string() +
              " --out " + (site / out).string());
    EXPECT_EQ(run.exit_code, 2) << out;
    EXPECT_NE(run.err.find("--out"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find(why), std::string::npos) << run.err;
  }
  EXPECT_EQ(files(), before);
}

TEST(Visit, WhenTheDiskTakesNoPostcardTheVisitGoesOnToItsKindWordsAndTheLogSaysWhy) {
  const ScratchFolder folder;
  const std::string out = (folder / "out").string();
  // 800 kB a file: enough for the pictures of small screens, not for the pot's model.
  const Outcome run = onggi("visit --script groove --vessel moon_jar --window 640x480 --out " + out,
                            "ulimit -f 800");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("pot.glb"), std::string::npos) << run.err;
  EXPECT_TRUE(fs::exists(out + "/screens/12_keepsake.png"));
  for (const auto& entry : fs::recursive_directory_iterator(out))
    EXPECT_EQ(entry.path().string().find("partial"), std::string::npos) << entry.path();
}

TEST(Visit, AnUnknownVesselIsRefusedWithTheNearestRightName) {
  const ScratchFolder folder;
  const Outcome run = onggi("visit --vessel moon_jra --out " + (folder / "out").string());
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("Did you mean moon_jar?"), std::string::npos) << run.err;
}

TEST(Visit, AnUnknownGlazeIsRefusedWithThoseThereAre) {
  const ScratchFolder folder;
  const Outcome run =
      onggi("visit --vessel moon_jar --glaze jade --out " + (folder / "out").string());
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("celadon, white_porcelain"), std::string::npos) << run.err;
}

TEST(Visit, AnUnknownScriptIsRefusedWithTheNearestRightName) {
  const ScratchFolder folder;
  const Outcome run =
      onggi("visit --script folow --vessel moon_jar --out " + (folder / "out").string());
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("follow"), std::string::npos) << run.err;
}

TEST(Visit, AnEmptyShelfIsNamedByItsPlace) {
  const ScratchFolder folder;
  fs::create_directory(folder / "shelf");
  const Outcome run = onggi("visit --vessel moon_jar --shelf " + (folder / "shelf").string() +
                            " --out " + (folder / "out").string());
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find((folder / "shelf").string()), std::string::npos) << run.err;
}

TEST(Visit, AGlazeThatADecoratedPotCannotHaveIsTheInputsFault) {
  const ScratchFolder folder;
  const Outcome run = onggi("visit --vessel onggi --script follow --decorate --glaze bare --out '" +
                            (folder / "out").string() + "'");
  EXPECT_EQ(run.exit_code, 2) << run.err;
  EXPECT_NE(run.err.find("glaze of its own"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace onggi::commands::visit_test
