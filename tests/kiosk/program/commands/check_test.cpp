#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>

#include "tests/kiosk/program/commands/program.h"

namespace onggi::commands::check_test {
namespace {

namespace fs = std::filesystem;

/// A site copied elsewhere, as a museum does: the exhibit, its languages and two vessels.
class CopiedSite : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(at("content/vessels"));
    fs::copy("config", at("config"), fs::copy_options::recursive);
    fs::copy("content/languages", at("content/languages"));
    fs::copy("content/lessons", at("content/lessons"));
    fs::copy("content/ways", at("content/ways"));
    fs::copy("content/glazes.toml", at("content/glazes.toml"));
    fs::copy("content/missions.toml", at("content/missions.toml"));
    fs::copy("content/names.toml", at("content/names.toml"));
    for (const char* id : {"moon_jar", "tea_bowl"})
      fs::copy(std::string("content/vessels/") + id, at(std::string("content/vessels/") + id));
  }
  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  Outcome check(const std::string& arguments = "") const {
    return onggi("check " + arguments, "cd '" + at("content") + "'");
  }
  void replace(const std::string& name, const std::string& what, const std::string& with) const {
    std::string text = content(at(name));
    const auto found = text.find(what);
    ASSERT_NE(found, std::string::npos) << what;
    text.replace(found, what.size(), with);
    std::ofstream(at(name)) << text;
  }
  const ScratchFolder folder_;
};

TEST_F(CopiedSite, IsWhatIsCheckedWhereOneStandsInItAndEachOfItsFilesIsNamed) {
  const Outcome run = check("--all");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  for (const char* name :
       {"config/exhibit.toml", "config/scenes/first_touch.toml", "config/rubric.toml",
        "content/languages/en.toml", "content/languages/ko.toml", "content/glazes.toml",
        "content/missions.toml", "content/lessons/first_minute.toml",
        "content/lessons/building.toml", "content/ways/celadon.toml",
        "content/vessels/moon_jar/vessel.toml", "content/vessels/moon_jar/profile.toml",
        "content/vessels/tea_bowl/vessel.glb"})
    EXPECT_NE(run.out.find("checked " + at(name) + "\n"), std::string::npos) << name << run.out;
  // The last line counts what the others name.
  const auto named = std::count(run.out.begin(), run.out.end(), '\n') - 1;
  EXPECT_NE(run.out.find("All good: checked " + std::to_string(named) + " files, "),
            std::string::npos)
      << run.out;
  EXPECT_NE(run.out.find("2 vessels, 2 languages."), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find(fs::current_path().string()), std::string::npos) << run.out;
  // Without being asked it says only that.
  const Outcome quiet = check();
  EXPECT_EQ(quiet.out, run.out.substr(run.out.find("All good")));
  EXPECT_EQ(quiet.err, "");
}

TEST_F(CopiedSite, ElsewhereIsNamedByConfig) {
  const Outcome run = onggi("check --all --config " + at("config/exhibit.toml"));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("checked " + at("content/languages/ko.toml")), std::string::npos);
  EXPECT_EQ(onggi("check --config " + at("no.toml")).exit_code, 2);
}

TEST_F(CopiedSite, WithWordsThatTheProgramDoesNotFindIsNotGood) {
  replace("content/languages/ko.toml", "\nbegin = ", "\nbegni = ");
  replace("content/languages/ko.toml", "{rpm}", "{rmp}");
  replace("content/languages/en.toml", "\nwater = \"Water\"\n", "\n");
  const Outcome run = check();
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_TRUE(std::regex_search(
      run.err, std::regex("ko.toml:[0-9]+:[0-9]+: attract.begni is not a text of the program."
                          "\n  Did you mean attract.begin")))
      << run.err;
  EXPECT_NE(run.err.find("throw.rpm has {rmp}, but the program fills no such placeholder."),
            std::string::npos);
  EXPECT_NE(run.err.find("Its placeholders are {rpm}."), std::string::npos) << run.err;
  EXPECT_TRUE(std::regex_search(
      run.err, std::regex("en.toml:[0-9]+:[0-9]+: throw.water is missing.\n.*water = \"Water\"")))
      << run.err;
  EXPECT_TRUE(run.out.starts_with("3 problems: ")) << run.out;
}

TEST_F(CopiedSite, WithAFolderThatHoldsNoVesselIsNotGood) {
  fs::create_directory(at("content/vessels/celadon"));
  const Outcome run = check();
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find(at("content/vessels/celadon") + ": "), std::string::npos) << run.err;
}

TEST_F(CopiedSite, AFolderOfNothingIsNotGood) {
  fs::create_directory(at("nothing"));
  const Outcome run = check(at("nothing"));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("There is no vessel here."), std::string::npos) << run.err;
}

TEST_F(CopiedSite, AnImportedScanIsAskedForUntilItsLabelIsWhole) {
  const std::string scan = at("scan.glb");
  fs::copy("content/vessels/tea_bowl/vessel.glb", scan);
  const Outcome import =
      onggi("vessel import " + scan + " --id bowl", "cd '" + at("content") + "'");
  ASSERT_EQ(import.exit_code, 0) << import.err;
  EXPECT_NE(import.out.find("vessels/bowl/vessel.toml"), std::string::npos) << import.out;
  EXPECT_NE(import.out.find("- the true size is missing"), std::string::npos) << import.out;
  EXPECT_NE(import.out.find("- there is no label in the language \"ko\""), std::string::npos);
  // Until it is complete, the exhibit is as good as before.
  const Outcome exhibit = check();
  EXPECT_EQ(exhibit.exit_code, 0) << exhibit.err;
  EXPECT_NE(exhibit.out.find("This vessel is unfinished, so visitors do not see it. "),
            std::string::npos)
      << exhibit.out;
  const std::string toml = at("content/vessels/bowl/vessel.toml");
  std::string first = content(toml), label, korean;
  std::string asked;
  int rounds = 0;
  // What a curator does: reads the first line of what is asked, and writes that.
  const std::vector<std::pair<std::string, std::string>> answers{
      {"true size", "true_height_mm = 75\n"},
      {"institution", "institution = \"A museum\"\n"},
      {"source", "source = \"Its catalogue\"\n"},
      {"credit", "credit = \"The scanner\"\n"},
      {"licence", "licence = \"CC0-1.0\"\n"},
      {"label.en.culture", "culture = \"Korea\"\n"},
      {"label.en.date", "date = \"undated\"\n"},
      {"label.en.made", "made = \"Thrown.\"\n"},
      {"label.en.text", "text = \"Look at its foot.\"\n"},
      {"language \"ko\"",
       "[label.ko]\ntitle = \"사발\"\nculture = \"한국\"\ndate = \"미상\"\nmade = \"물레\"\n"
       "text = \"굽을 보자.\"\n"},
      {"Nothing is missing", ""}};
  Outcome run = check(at("content/vessels/bowl"));
  for (; run.exit_code == 2 && rounds < 20; ++rounds) {
    const auto answer = std::find_if(answers.begin(), answers.end(), [&](const auto& a) {
      return run.err.substr(0, run.err.find('\n')).find(a.first) != std::string::npos;
    });
    ASSERT_NE(answer, answers.end()) << run.err;
    asked += answer->first + "; ";
    std::string text = content(toml);
    if (answer->second.empty()) {
      std::ofstream(toml) << std::regex_replace(text, std::regex("unfinished = true[^\n]*\n"), "");
      run = check();
      EXPECT_NE(run.out.find("3 vessels"), std::string::npos) << run.out;
      continue;
    }
    const std::string key = answer->second.substr(0, answer->second.find(' '));
    text = std::regex_replace(text, std::regex("(^|\n)" + key + " = [^\n]*\n"), "$1");
    const auto head = text.find("[label.en]");
    const auto end = text.find('\n', head) + 1;
    if (answer->first.starts_with("label.en"))
      text.insert(end, answer->second);
    else if (answer->first.starts_with("language"))
      text += answer->second;
    else
      text.insert(head, answer->second);
    std::ofstream(toml) << text;
    run = check(at("content/vessels/bowl"));
  }
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_GE(rounds, 7) << asked;
  EXPECT_NE(asked.find("language \"ko\""), std::string::npos) << asked;
}

TEST_F(CopiedSite, WhatAVisitorShouldNotReadIsNamed) {
  const std::string name = "content/vessels/tea_bowl/vessel.toml";
  replace(name, "licence = \"CC0-1.0\"", "licence = \" \"");
  EXPECT_NE(check().err.find("licence is empty."), std::string::npos);
  replace(name, "licence = \" \"", "licence = \"not known\"");
  EXPECT_NE(check().err.find("the licence is \"not known\""), std::string::npos);
  for (const std::string word : {"TODO", "tbd", "?"}) {
    replace(name, "licence = \"not known\"", "licence = \"" + word + "\"");
    EXPECT_NE(check().err.find("the licence is \"" + word + "\""), std::string::npos) << word;
    replace(name, "licence = \"" + word + "\"", "licence = \"not known\"");
  }
  replace(name, "licence = \"not known\"", "licence = \"CC0-1.0\"");
  EXPECT_EQ(check().exit_code, 0);
  std::string text = content(at(name));
  for (const char* part : {"title", "culture", "date", "made", "text"}) {
    const std::regex first("\n" + std::string(part) + " = [^\n]*");
    std::ofstream(at(name)) << std::regex_replace(text, first,
                                                  "\n" + std::string(part) + " = \" \"",
                                                  std::regex_constants::format_first_only);
    EXPECT_NE(check().err.find(std::string(part) + " is empty."), std::string::npos) << check().err;
  }
  std::string words;
  for (int i = 0; i < 101; ++i) words += "foot ";
  std::ofstream(at(name)) << std::regex_replace(text, std::regex("\ntext = [^\n]*"),
                                                "\ntext = \"" + words + "\"",
                                                std::regex_constants::format_first_only);
  EXPECT_NE(check().err.find("the label has 101 words"), std::string::npos) << check().err;
  std::ofstream(at(name)) << text.substr(0, text.find("[label.ko]"));
  EXPECT_NE(check().err.find("no label in the language \"ko\""), std::string::npos);
  std::ofstream(at(name)) << std::regex_replace(text, std::regex("true_[a-z]+_mm = [0-9.]+\n"), "");
  EXPECT_NE(check().err.find("true size is missing"), std::string::npos) << check().err;
}

TEST_F(CopiedSite, ATranslatorWritesOneFileAndItsFaultsAreNamedThere) {
  replace("config/exhibit.toml", "languages = [\"en\", \"ko\"]", "languages = [\"en\", \"nl\"]");
  replace("config/exhibit.toml", "ko = \"도자기 빚기\"", "nl = \"Maak een pot\"");
  std::string words = content(at("content/languages/en.toml"));
  words = std::regex_replace(words, std::regex("code = \"en\""), "code = \"nl\"");
  std::ofstream(at("content/languages/nl.toml")) << words;
  const std::string copied = check().err;
  EXPECT_TRUE(
      std::regex_search(copied, std::regex("nl.toml:[0-9]+:1: [0-9]+ of [0-9]+ longer texts "
                                           "are still in English")))
      << copied;
  words = std::regex_replace(words, std::regex("= \"([^\"\n]+ )"), "= \"Ja, $1");
  std::ofstream(at("content/languages/nl.toml")) << words;
  const std::string before = check().err;
  EXPECT_LE(std::count(before.begin(), before.end(), '\n'), 40) << before;
  EXPECT_NE(before.find("more like these. onggi check --all lists them."), std::string::npos);
  EXPECT_EQ(before.find("still in English"), std::string::npos) << before;
  const Outcome each = check("--all");
  EXPECT_GT(each.err.size(), before.size());
  EXPECT_EQ(each.err.find("more like these"), std::string::npos);
  for (const char* lacks : {"no label in the language \"nl\"", "no name in the language \"nl\"",
                            "no words in the language \"nl\"", "no title in the language \"nl\""})
    EXPECT_NE(before.find(lacks), std::string::npos) << lacks << before;
  for (const char* id : {"moon_jar", "tea_bowl"})
    words += std::string("[vessel.") + id + "]\ntitle = \"Pot\"\n";
  const auto add = [&words](const char* file, const std::string& kind, const std::string& texts) {
    const std::string text = content(file);
    const std::regex id("\nid = \"([a-z_]+)\"");
    for (std::sregex_iterator it(text.begin(), text.end(), id), end; it != end; ++it)
      words += "[" + kind + "." + (*it)[1].str() + "]\n" + texts;
  };
  add("content/glazes.toml", "glaze", "name = \"Groen\"\n");
  add("content/missions.toml", "mission", "title = \"Een liter\"\nabout = \"Maak het.\"\n");
  for (const char* lesson : {"content/lessons/first_minute.toml", "content/lessons/building.toml"})
    add(lesson, "lesson", "words = \"Raak de klei aan.\"\n");
  std::ofstream(at("content/languages/nl.toml")) << words;
  const Outcome good = check();
  EXPECT_EQ(good.exit_code, 0) << good.err;
  std::ofstream(at("content/languages/nl.toml"))
      << words + "[glaze.celadn]\nname = \"Groen\"\n[vessel.krug]\ntitle = \"Kruik\"\n";
  const auto line = std::to_string(std::count(words.begin(), words.end(), '\n') + 1);
  const std::string bad = check().err;
  EXPECT_NE(bad.find("nl.toml:" + line), std::string::npos) << bad;
  EXPECT_NE(bad.find("Did you mean [glaze.celadon]?"), std::string::npos) << bad;
  EXPECT_NE(bad.find("This exhibit has no vessel \"krug\"."), std::string::npos) << bad;
}

}  // namespace
}  // namespace onggi::commands::check_test
