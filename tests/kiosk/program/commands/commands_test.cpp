#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "engine/script/script.h"
#include "tests/kiosk/program/commands/program.h"

namespace onggi::commands::commands_test {
namespace {

TEST(Commands, EveryCommandHasHelpWithAnExample) {
  for (const char* command :
       {"", "run", "visit", "replay", "check", "vessel", "vessel make", "vessel inspect",
        "vessel decorate", "vessel import", "score", "soak", "lab", "lab effects", "lab stability",
        "lab timing", "lab witness", "devices", "poster"}) {
    const Outcome run = onggi(std::string(command) + " --help");
    EXPECT_EQ(run.exit_code, 0) << command;
    EXPECT_NE(run.out.find("Example: onggi"), std::string::npos) << command;
  }
}

TEST(Commands, TheHelpOfAVisitNamesEveryScript) {
  const Outcome run = onggi("visit --help");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const std::string_view name : script_names())
    EXPECT_NE(run.out.find(name), std::string::npos) << name;
}

TEST(Commands, TheVersionIsAWordAndANumber) {
  const Outcome run = onggi("--version");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out.rfind("onggi ", 0), 0u) << run.out;
}

TEST(Commands, AWrongOptionIsTheInputsFault) {
  for (const char* wrong :
       {"--windw 1x1", "bogus", "visit", "run --window 10", "replay /nowhere", "check /nowhere",
        "vessel inspect /nowhere", "score /nowhere /nowhere", "vessel make /nowhere.toml",
        "--config config/exhibit.toml check", "--window 640x480 lab tune",
        "stats --store a --config b", "lab stability --check a --json -"}) {
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

TEST(Lab, TheLoopsTimesAreToldAloneAndBesideTheDrawingWithAVerdictInWords) {
  const ScratchFolder folder;
  const std::string plot = (folder / "timing.svg").string();
  const Outcome run = onggi("lab timing --seconds 2 --json - --plot " + plot);
  EXPECT_TRUE(run.exit_code == 0 || run.exit_code == 1) << run.err;
  const auto report = nlohmann::json::parse(run.out);
  EXPECT_EQ(report.at("fit_for_force").get<bool>(), run.exit_code == 0);
  ASSERT_EQ(report.at("phases").size(), 2u);
  for (const auto& phase : report.at("phases")) {
    EXPECT_GT(phase.at("wake_us").at("count").get<int>(), 100) << phase.at("name");
    EXPECT_GE(phase.at("wake_us").at("p99.9").get<double>(),
              phase.at("wake_us").at("p50").get<double>());
    EXPECT_GT(phase.at("compute_us").at("max").get<double>(), 0.0);
    EXPECT_GT(phase.at("shown_age_us").at("count").get<int>(), 0);
  }
  // Two seconds are no tail, and it says so.
  std::string words;
  for (const auto& sentence : report.at("words")) words += sentence.get<std::string>();
  EXPECT_NE(words.find("too few for the tail"), std::string::npos) << words;
  EXPECT_NE(content(plot).find("<svg"), std::string::npos);
}

TEST(Lab, ThePriceListNamesEveryEffectAndEveryScene) {
  const ScratchFolder folder;
  const std::string json = (folder / "prices.json").string();
  const Outcome run = onggi("lab effects --quick --grid 60x48 --json " + json);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto list = nlohmann::json::parse(std::ifstream(json)).at("prices");
  std::string names;
  for (const auto& price : list) {
    names += price.at("scene").get<std::string>() + "; ";
    EXPECT_GT(price.at("median_ns").get<double>(), 0.0);
    EXPECT_GE(price.at("p999_ns").get<double>(), price.at("median_ns").get<double>());
  }
  EXPECT_EQ(names,
            "base; + moisture; + walls; + propagation; + springback; + smoothing; + wobble; "
            "+ slump (and volume); + volume; + building (and volume); + beating (and volume); + "
            "prints (and beating) (and volume); + friction; + kiln; "
            "built.toml; first_touch.toml; master.toml; "
            "paper.toml; studio.toml; all; ");
}

TEST(Lab, ThePriceListGoesToStandardOutputWhereThatIsAskedFor) {
  const Outcome run = onggi("lab effects --quick --grid 60x48 --json -");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(nlohmann::json::parse(run.out).at("prices").size(), 20u);
  EXPECT_NE(run.err.find("p99.9"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists("-"));
}

TEST(Lab, ThePriceListIsDrawnWithNothingButTheProgramItself) {
  const ScratchFolder folder;
  for (const auto& [name, begins] : {std::pair{"prices.svg", "<?xml"}, {"prices.png", "\x89PNG"}}) {
    const std::string file = (folder / name).string();
    // No shell, no gnuplot, no valgrind: nothing is found in the path.
    const Outcome run =
        onggi("lab effects --quick --grid 60x48 --plot " + file, "export PATH=/nowhere");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(content(file).rfind(begins, 0), 0u) << name;
    EXPECT_GT(content(file).size(), 20000u) << name;
  }
  EXPECT_EQ(onggi("lab effects --quick --grid 60x48 --plot /proc/no.png").exit_code, 1);
}

TEST(Lab, ANightOfTrialsLeavesItsTallyAndGoesOnWhereItWas) {
  const ScratchFolder folder;
  const std::string out = " --threads 1 --seed 3 --out " + (folder / "night").string();
  const Outcome first = onggi("lab stability --ticks 9000 --json -" + out);
  EXPECT_EQ(first.exit_code, 0) << first.err;
  const auto tally = nlohmann::json::parse(first.out);
  EXPECT_GE(tally.at("ticks").get<double>(), 9000.0);
  EXPECT_TRUE(tally.at("found").empty());
  const Outcome next = onggi("lab stability --ticks 10000" + out);
  EXPECT_EQ(next.exit_code, 0) << next.err;
  EXPECT_NE(next.err.find("Continues from trial"), std::string::npos);
  EXPECT_NE(next.out.find("seed 3"), std::string::npos);
  const Outcome one = onggi("lab stability --trial 1" + out);
  EXPECT_EQ(one.exit_code, 0) << one.err;
  EXPECT_NE(one.out.find("seed 3, 1 trials"), std::string::npos);
  EXPECT_EQ(onggi("lab stability --trial -1").exit_code, 2);
  EXPECT_EQ(onggi("lab stability --ticks 0").exit_code, 2);
  EXPECT_EQ(onggi("lab stability --check /nowhere.onggi").exit_code, 2);
}

TEST(Lab, AGridThatIsNoneIsTheInputsFault) {
  EXPECT_EQ(onggi("lab effects --grid 60").exit_code, 2);
  EXPECT_EQ(onggi("lab effects --grid 2x2 --quick").exit_code, 2);
}

TEST(Check, TheExhibitThatComesWithTheProgramIsGood) {
  const Outcome run = onggi("check");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(run.out.starts_with("All good: checked ")) << run.out;
}

TEST(Check, AScriptThatAttractModeDoesNotShowIsNamedWithThoseThatItDoes) {
  const ScratchFolder folder;
  const std::string file =
      write_exhibit(folder, "studio", "[attract]\nscripts = [\"follow\", \"colapse\"]\n");
  const Outcome run = onggi("check " + file);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("exhibit.toml:5:22"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("collapse"), std::string::npos) << run.err;
}

TEST(Check, ASceneForAVesselThatIsNotOnTheShelfIsNamedWithTheNearestThatIs) {
  const ScratchFolder folder;
  const std::string file =
      write_exhibit(folder, "studio",
                    "[vessel_scenes]\nmoonjar = \"" + std::filesystem::current_path().string() +
                        "/config/scenes/master.toml\"\n");
  const Outcome run = onggi("check " + file);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("exhibit.toml:5:"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("Did you mean moon_jar?"), std::string::npos) << run.err;
}

TEST(Check, EverySlipOfAnExhibitIsNamedAtOnceWithLineColumnAndRemedy) {
  const ScratchFolder folder;
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
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "empty");
  const Outcome run = onggi("check " + (folder / "empty").string());
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("no vessel"), std::string::npos) << run.err;
}

TEST(Vessel, ADrawingBecomesAGlbThatMeasuresAsDrawn) {
  const ScratchFolder folder;
  const std::string glb = (folder / "vessel.glb").string();
  const Outcome make = onggi("vessel make content/vessels/moon_jar/profile.toml -o " + glb);
  ASSERT_EQ(make.exit_code, 0) << make.err;
  EXPECT_EQ(content(glb), content("content/vessels/moon_jar/vessel.glb"));
  const Outcome inspect = onggi("vessel inspect --json - " + glb);
  ASSERT_EQ(inspect.exit_code, 0) << inspect.err;
  EXPECT_NEAR(nlohmann::json::parse(inspect.out)["height_m"].get<double>(), 0.305, 0.003);
}

TEST(Vessel, WhatIsInspectedIsToldInJsonAndDrawn) {
  const ScratchFolder folder;
  const std::string png = (folder / "jar.png").string();
  const Outcome run = onggi("vessel inspect content/vessels/moon_jar --json - --plot " + png);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto report = nlohmann::json::parse(run.out);
  for (const char* key :
       {"file", "nodes", "triangles", "height_m", "axis", "up", "symmetry", "masked_fraction",
        "inner", "outer", "inner_profile", "warnings", "licence", "credit"})
    EXPECT_TRUE(report.contains(key)) << key;
  EXPECT_EQ(report["axis"]["origin"].size(), 3u);
  EXPECT_EQ(report["outer"][0].size(), 2u);
  EXPECT_EQ(report["inner"], "measured");
  const std::string picture = content(png);
  EXPECT_GT(picture.size(), 50000u);
  EXPECT_EQ(picture.substr(1, 3), "PNG");
}

TEST(Vessel, AScanBecomesAPackThatTheKioskOpens) {
  const ScratchFolder folder;
  const std::string shelf = (folder / "shelf").string();
  const std::string command =
      "vessel import content/vessels/tea_bowl/vessel.glb --id my_bowl --shelf " + shelf;
  EXPECT_EQ(onggi(command).exit_code, 2) << "a shelf that nobody asked for";
  EXPECT_FALSE(std::filesystem::exists(shelf));
  std::filesystem::create_directory(shelf);
  ASSERT_EQ(onggi(command).exit_code, 0);
  EXPECT_EQ(content(shelf + "/my_bowl/vessel.glb"), content("content/vessels/tea_bowl/vessel.glb"));
  EXPECT_EQ(onggi("vessel inspect " + shelf + "/my_bowl").exit_code, 0);
  const Outcome again = onggi(command);
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_NE(again.err.find("is not overwritten"), std::string::npos);
  EXPECT_EQ(onggi("vessel import content/vessels/tea_bowl/vessel.glb --id ../x").exit_code, 2);
  const Outcome nowhere = onggi("vessel import '" + shelf + "/my_bowl/vessel.glb' --id bowl",
                                "cd '" + (folder / "").string() + "'");
  EXPECT_EQ(nowhere.exit_code, 2);
  EXPECT_NE(nowhere.err.find("There is no exhibit in this folder"), std::string::npos);
}

TEST(Poster, IsAFourUprightAndAVesselThatIsNotThereIsNamed) {
  const ScratchFolder folder;
  const std::string png = (folder / "poster.png").string();
  const Outcome run = onggi("poster --address https://museum.org -o " + png);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string picture = content(png);
  ASSERT_GT(picture.size(), 300'000u);
  const auto number_at = [&picture](std::size_t at) {
    return static_cast<unsigned char>(picture[at + 2]) * 256 +
           static_cast<unsigned char>(picture[at + 3]);
  };
  EXPECT_EQ(number_at(16), 2480);
  EXPECT_EQ(number_at(20), 3508);
  const Outcome wrong = onggi("poster --vessel moonjar -o " + png);
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.err.find("Did you mean moon_jar?"), std::string::npos) << wrong.err;
  EXPECT_EQ(onggi("poster --address http://kiosk -o " + png).exit_code, 2);
}

TEST(Vessel, WhatCannotBeATargetEndsWithTwoPlaceMeaningAndRemedy) {
  const std::string ewer = "../shared/vessels/sketchfab_ewer_dmitriy_draco.glb";
  if (!std::filesystem::exists(ewer)) GTEST_SKIP() << "there is no " << ewer;
  const Outcome run = onggi("vessel inspect " + ewer + " --json -");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.out, "");
  for (const char* words : {"ewer", "not a body of revolution", "Choose a vessel"})
    EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
}

TEST(Score, ADrawingIsItsOwnGlbAndABowlIsNoJar) {
  const std::string jar = "content/vessels/moon_jar/";
  for (const std::string& pot :
       {jar, jar + "vessel.glb", jar + "vessel.toml", jar + "profile.toml"}) {
    const Outcome run = onggi("score " + jar + "profile.toml " + pot + " --json -");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_GT(nlohmann::json::parse(run.out)["score"].get<double>(), 99.0) << pot;
  }
  const Outcome run = onggi("score content/vessels/tea_bowl " + jar + " --json -");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto report = nlohmann::json::parse(run.out);
  EXPECT_LT(report["score"].get<double>(), 50.0);
  EXPECT_NE(report["words"].get<std::string>().find(" mm too "), std::string::npos);
  for (const char* key : {"outline_rms", "outline_worst", "volume_overlap", "turning_rms_degrees"})
    EXPECT_TRUE(report["measures"].contains(key)) << key;
}

TEST(Score, TheRubricIsPolicy) {
  const ScratchFolder folder;
  const std::string file = (folder / "rubric.toml").string();
  const std::string command = "score content/vessels/meiping content/vessels/maebyeong --json - ";
  const double usual = nlohmann::json::parse(onggi(command).out)["score"].get<double>();
  std::ofstream(file) << "[outline]\nhalf = 0.2\n";
  const double mild =
      nlohmann::json::parse(onggi(command + "--rubric " + file).out)["score"].get<double>();
  EXPECT_GT(mild, usual + 10.0);
  std::ofstream(file) << "[outline]\nhalf = 20\n[wal]\nshare = 0\n";
  const Outcome wrong = onggi(command + "--rubric " + file);
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.err.find("rubric.toml:2:"), std::string::npos) << wrong.err;
  EXPECT_EQ(onggi("check " + file).exit_code, 2);
  EXPECT_EQ(onggi("check config/rubric.toml").exit_code, 0);
}

TEST(Replay, AFileThatIsNoReplayIsRefusedWithAMeaning) {
  const ScratchFolder folder;
  const std::string file = (folder / "visit.onggi").string();
  std::ofstream(file) << "not a replay at all";
  const Outcome run = onggi("replay " + file);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find(file), std::string::npos);
}

}  // namespace
}  // namespace onggi::commands::commands_test
