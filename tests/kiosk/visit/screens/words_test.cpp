#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#include "kiosk/collection/content/language.h"
#include "kiosk/collection/score/score.h"
#include "kiosk/visit/screens/measured_pot.h"
#include "kiosk/visit/screens/screen_kind.h"
#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::words_test {
namespace {

content::Language read(const std::string& code) {
  auto language = content::Language::read("content/languages/" + code + ".toml");
  EXPECT_TRUE(language) << (language ? "" : to_text(language.error()));
  return language ? *language : content::Language{};
}

std::multiset<std::string> places(const std::string& words) {
  static const std::regex kPlace("\\{[a-z_]+\\}");
  std::multiset<std::string> found;
  for (auto i = std::sregex_iterator(words.begin(), words.end(), kPlace);
       i != std::sregex_iterator(); ++i)
    found.insert(i->str());
  return found;
}

/// All that come with the exhibit, offered or not.
std::vector<content::Language> all_languages() {
  std::vector<content::Language> all;
  for (const auto& file : std::filesystem::directory_iterator("content/languages"))
    all.push_back(read(file.path().stem().string()));
  return all;
}

// The two that are offered from the start say all; another may say a new thing in English until
// somebody has translated it, and nothing else.
TEST(Words, EveryLanguageThatComesSaysTheSameThingsWithTheSamePlaces) {
  const auto en = read("en");
  const auto all = all_languages();
  EXPECT_GE(all.size(), 5u);
  std::set<std::string> codes;
  const settings::Exhibit exhibit;
  const std::set<std::string> offered(exhibit.languages.begin(), exhibit.languages.end());
  for (const auto& language : all) {
    SCOPED_TRACE(language.code());
    EXPECT_TRUE(codes.insert(language.code()).second) << "two files have one code";
    for (const std::string& key : language.keys()) EXPECT_TRUE(en.has(key)) << key;
    if (offered.contains(language.code())) {
      EXPECT_EQ(en.keys(), language.keys());
    }
    for (const std::string& key : en.keys())
      EXPECT_EQ(places(en.say(key)), places(language.say(key))) << key;
  }
}

/// The strings of the source that name words, "throw.done", or a family of them, "mission.title_":
/// all that stand in a table of `tables` or are handed to say().
std::set<std::string> named_in_the_source(const std::set<std::string>& tables) {
  static const std::regex kName("(say\\()?\"([a-z_]+)\\.([a-z_0-9]*)\"");
  std::set<std::string> named;
  for (const auto& file : std::filesystem::recursive_directory_iterator("kiosk")) {
    if (file.path().extension() != ".cpp" && file.path().extension() != ".h") continue;
    std::ifstream in(file.path());
    for (std::string line; std::getline(in, line);)
      for (auto i = std::sregex_iterator(line.begin(), line.end(), kName);
           i != std::sregex_iterator(); ++i)
        if ((*i)[1].matched || tables.contains((*i)[2]))
          named.insert((*i)[2].str() + "." + (*i)[3].str());
  }
  return named;
}

TEST(Words, EveryKeyThatTheSourceNamesIsThereAndEveryKeyIsNamed) {
  const auto all = read("en").keys();
  const std::set<std::string> keys(all.begin(), all.end());
  std::set<std::string> tables;
  for (const std::string& key : keys) tables.insert(key.substr(0, key.find('.')));
  const std::set<std::string> named = named_in_the_source(tables);
  // Controls with words of another name, files, and keys of curators' files.
  const std::set<std::string> no_words{
      "attract.gallery", "keepsake.gallery", "throw.tell",      "clay.on",       "clay.rows",
      "decorate.mark",   "decorate.on",      "decorate.show",   "result.onward", "postcard.jpg",
      "postcard.png",    "sheet.jpg",        "idle.warn_after", "mission.about", "mission.title",
      "keepsake.folder", "mission.id"};
  const auto begins_a_key = [&](const std::string& name) {
    const auto key = keys.lower_bound(name);
    return key != keys.end() && key->starts_with(name);
  };
  const auto family = [](const std::string& name) {
    return name.ends_with('.') || name.ends_with('_');
  };
  for (const std::string& name : named)
    EXPECT_TRUE(keys.contains(name) || no_words.contains(name) ||
                (family(name) && begins_a_key(name)))
        << name;
  for (const std::string& name : no_words) EXPECT_TRUE(named.contains(name)) << name;
  for (const std::string& key : keys)
    EXPECT_TRUE(
        named.contains(key) ||
        std::ranges::any_of(
            named, [&](const std::string& name) { return family(name) && key.starts_with(name); }))
        << key << " is said nowhere";
}

// Also in what others than the screens print: labels, glazes, the lesson, missions.
TEST(Words, AnApostropheIsNoStraightOneInAnyTextThatAVisitorReads) {
  static const std::regex kStraight("[[:alnum:]]'[[:alnum:]]|[[:alnum:]]' ");
  int files = 0;
  for (const auto& file : std::filesystem::recursive_directory_iterator("content")) {
    if (file.path().extension() != ".toml") continue;
    // Its keys are the sources' English, and no visitor reads it.
    if (file.path().parent_path() == "content/staff") continue;
    ++files;
    std::ifstream in(file.path());
    for (std::string line; std::getline(in, line);) {
      const auto text = line.find('"'), end = line.rfind('"');
      if (line.starts_with('#') || text == std::string::npos || end == text) continue;
      EXPECT_FALSE(std::regex_search(line.substr(text, end - text), kStraight))
          << file.path() << ": " << line;
    }
  }
  EXPECT_GT(files, 20);
}

TEST(Words, EveryRemarkOfAScoreHasItsWords) {
  for (const auto& language : all_languages())
    for (const std::string& key : score::remark_keys())
      EXPECT_NE(language.say(key).front(), '[') << language.code() << " " << key;
}

TEST(Words, EveryHintAndTitleOfADescriptionHasItsWords) {
  std::vector<std::string> keys = MeasuredPot::hints();
  for (int stars = 1; stars <= 5; ++stars) keys.push_back("mission.title_" + std::to_string(stars));
  settings::Mission::Described wanted;
  wanted.height = wanted.mouth = settings::Mission::Described::Bounds{0.1, 0.1};
  for (const auto& one : score::asked_of(wanted, {})) keys.push_back(one.key);
  EXPECT_EQ(keys.size(), 15u);
  for (const auto& language : all_languages())
    for (const std::string& key : keys)
      EXPECT_NE(language.say(key).front(), '[') << language.code() << " " << key;
}

TEST(Words, EveryScreenHasItsHelp) {
  for (const auto& language : all_languages())
    for (const ScreenKind& screen : screen_kinds())
      for (const char* kind : {"", "_keys"})
        EXPECT_NE(language.say("help." + std::string(screen.name) + kind).front(), '[');
}

TEST(Words, EnglishSentencesHaveAtMostTwentyFiveWords) {
  const auto en = read("en");
  for (const std::string& key : en.keys()) {
    int words = 0;
    for (const char c : en.say(key) + " ") {
      if (c == ' ') ++words;
      if (c == '.' || c == '?' || c == ':') words = 0;
      EXPECT_LE(words, 25) << key;
    }
  }
}

TEST(Words, ALabelSaysAtWhatPartOfItsSizeAVesselIsThrown) {
  Visitor v(3);
  v.shelf[1].scale = 1.0;
  v.shelf[2].scale = 1.42;
  v.touch("attract.begin");
  v.frames(1);
  const auto label = [&v](int card) {
    v.touch("choose.card." + std::to_string(card));
    v.frames(1);
    const std::string words = words_in(v.frame);
    v.touch("back");
    v.frames(1);
    return words;
  };
  EXPECT_NE(label(0).find("Shown at 65 % of its real size, to fit the wheel"), std::string::npos);
  EXPECT_EQ(label(1).find("of its real size"), std::string::npos);
  EXPECT_NE(label(2).find("Small, so shown at 142 % of its real size"), std::string::npos);
}

}  // namespace
}  // namespace onggi::screens::words_test
