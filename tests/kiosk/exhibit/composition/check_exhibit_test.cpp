#include "kiosk/exhibit/composition/check_exhibit.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/kiosk/program/commands/temporary_exhibit.h"

namespace onggi::exhibit::check_exhibit_test {
namespace {

TEST(CheckExhibit, AskedToStopItComesToNoFurtherVessel) {
  std::stop_source stop;
  const auto whole = check_path("", "config/exhibit.toml", stop.get_token());
  stop.request_stop();
  const auto cut = check_path("", "config/exhibit.toml", stop.get_token());
  ASSERT_TRUE(whole && cut);
  EXPECT_EQ(whole->vessels, 12);
  EXPECT_EQ(cut->vessels, 0);
}

/// The project's exhibit with `lists` above its tables.
CheckReport check_with(const std::string& lists) {
  const commands::ScratchFolder folder;
  for (const char* part : {"config", "content"})
    std::filesystem::copy(part, folder / part, std::filesystem::copy_options::recursive);
  std::ofstream(folder / "config/exhibit.toml") << lists;
  return *check_path((folder / "config/exhibit.toml").string());
}

TEST(CheckExhibit, WordsOfTheStaffsPageAreNoExhibit) {
  const auto report = check_path("content/staff/ko.toml");
  ASSERT_TRUE(report);
  EXPECT_TRUE(report->problems.empty());
  ASSERT_EQ(report->notes.size(), 1u);
  EXPECT_EQ(report->notes[0].what, "These are words of the staff's page.");
}

TEST(CheckExhibit, ANameInTheListsOfTheShelfThatIsNotThereIsToldWithTheNearestOne) {
  const CheckReport report =
      check_with("hidden = [\"tea_bowl\", \"lekytos\"]\norder = [\"maebyeong\", \"amfora\"]\n");
  ASSERT_EQ(report.problems.size(), 2u);
  EXPECT_EQ(to_text(report.problems[0]).substr(to_text(report.problems[0]).find("exhibit.toml")),
            "exhibit.toml:1:23: There is no vessel \"lekytos\" on the shelf.\n"
            "  Did you mean lekythos?");
  EXPECT_NE(report.problems[1].what.find("\"amfora\""), std::string::npos);
  EXPECT_NE(report.problems[1].remedy.find("or remove it."), std::string::npos);
  EXPECT_EQ(report.vessels, 11);
}

TEST(CheckExhibit, AMistakeInAWayIsToldOnceThoughAVesselNamesThatWay) {
  const commands::ScratchFolder folder;
  for (const char* part : {"config", "content"})
    std::filesystem::copy(part, folder / part, std::filesystem::copy_options::recursive);
  const auto file = (folder / "config/exhibit.toml").string(),
             way = (folder / "content/ways/celadon.toml").string();
  std::ofstream(file) << "languages = [\"en\"]\n[title]\nen = \"A\"\n";
  std::ofstream(way, std::ios::app)
      << "[[tool]]\nid = \"weave\"\nlaw = \"weave\"\nhand = \"line\"\n";
  const auto report = check_path(file);
  ASSERT_EQ(report->problems.size(), 1u);
  EXPECT_EQ(report->problems[0].what, "There is no law \"weave\".");
}

TEST(CheckExhibit, AFolderOfWaysThatIsEmptyIsToldAtItsLineUnlessNobodyMayDecorate) {
  const commands::ScratchFolder folder;
  for (const char* part : {"config", "content"})
    std::filesystem::copy(part, folder / part, std::filesystem::copy_options::recursive);
  std::filesystem::create_directory(folder / "none");
  const auto file = (folder / "config/exhibit.toml").string();
  const auto problems = [&](const std::string& lines) {
    std::ofstream(file) << "languages = [\"en\"]\n" + lines + "[title]\nen = \"A\"\n";
    return check_path(file)->problems;
  };
  const auto told = problems("ways = \"../none\"\n");
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].where.find("exhibit.toml:2:"), std::string::npos) << told[0].where;
  EXPECT_EQ(told[0].what, "This folder of ways is empty: it has no file *.toml.");
  EXPECT_NE(told[0].remedy.find("decorate = false"), std::string::npos);
  EXPECT_TRUE(problems("ways = \"../none\"\ndecorate = false\n").empty());
  for (const auto& entry : std::filesystem::directory_iterator(folder / "content/ways"))
    std::filesystem::remove(entry.path());
  const auto usual = problems("");
  ASSERT_EQ(usual.size(), 1u);
  EXPECT_NE(usual[0].where.find("content/ways"), std::string::npos) << usual[0].where;
}

// What other files say about a hidden vessel stays right.
TEST(CheckExhibit, AHiddenVesselMayHaveASceneAndWordsInEveryLanguage) {
  EXPECT_TRUE(check_with("hidden = [\"moon_jar\"]\nlanguages = [\"en\", \"de\"]\n[title]\nen = "
                         "\"A\"\nde = \"B\"\n[vessel_scenes]\nmoon_jar = "
                         "\"scenes/master.toml\"\n")
                  .problems.empty());
}

TEST(CheckExhibit, AMissionsPotThatCannotBeThrownIsToldAtItsLitres) {
  const commands::ScratchFolder folder;
  for (const char* part : {"config", "content"})
    std::filesystem::copy(part, folder / part, std::filesystem::copy_options::recursive);
  std::ofstream(folder / "config/exhibit.toml") << "languages = [\"en\"]\n[title]\nen = \"A\"\n";
  const auto file = folder / "content/missions.toml";
  std::ofstream(file) << "[[mission]]\nid = \"good\"\nkind = \"describe\"\nlitres = 1\n"
                         "title.en = \"A\"\nabout.en = \"B\"\n"
                         "[[mission]]\nid = \"cannot_be\"\nkind = \"describe\"\n"
                         "height_mm = [40, 45]\nlitres = 3\ntitle.en = \"A\"\nabout.en = \"B\"\n";
  const auto report = check_path((folder / "config/exhibit.toml").string());
  ASSERT_TRUE(report);
  ASSERT_EQ(report->problems.size(), 1u);
  EXPECT_NE(report->problems[0].where.find("missions.toml:11:"), std::string::npos)
      << report->problems[0].where;
  EXPECT_NE(report->problems[0].what.find("litres"), std::string::npos);
}

TEST(CheckExhibit, AShelfThatIsAllHiddenIsAProblem) {
  std::string all;
  for (const auto& entry : std::filesystem::directory_iterator("content/vessels"))
    all += (all.empty() ? "\"" : ", \"") + entry.path().filename().string() + "\"";
  const CheckReport report = check_with("hidden = [" + all + "]\n");
  ASSERT_EQ(report.problems.size(), 1u);
  EXPECT_EQ(report.problems[0].what, "Every vessel of this shelf is hidden or unfinished.");
}

}  // namespace
}  // namespace onggi::exhibit::check_exhibit_test
