#include "kiosk/collection/content/language.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/kiosk/collection/content/temporary.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::content::language_test {
namespace {

class LanguageTest : public Temporary {};

TEST_F(LanguageTest, words_are_filled_into_their_places) {
  const auto language =
      Language::read(write("ko.toml",
                           "code = \"ko\"\nname = \"한국어\"\n[text]\n"
                           "\"remark.wide\" = \"{mm}밀리미터\"\nplain = \"그릇\"\n"));
  ASSERT_TRUE(language) << to_text(language.error());
  EXPECT_EQ(language->name(), "한국어");
  EXPECT_FALSE(language->right_to_left());
  EXPECT_EQ(language->say("remark.wide", {{"mm", "8"}}), "8밀리미터");
  EXPECT_EQ(language->say("remark.wide", {{"other", "8"}}), "{mm}밀리미터");
  EXPECT_EQ(language->say("nothing"), "[nothing]");
  EXPECT_EQ(language->places("remark.wide"), std::vector<std::string>{"mm"});
  EXPECT_EQ(language->keys().size(), 2u);
}

TEST_F(LanguageTest, what_it_lacks_is_said_in_english) {
  const auto language = Language::read(
      write("ko.toml", "code = \"ko\"\nname = \"한국어\"\n[text]\ntool.wire = \"철사\"\n"));
  ASSERT_TRUE(language) << to_text(language.error());
  EXPECT_EQ(language->say("tool.wire"), "철사");
  EXPECT_EQ(language->say("tool.needle"), "Needle");
  EXPECT_FALSE(language->has("tool.needle"));
  EXPECT_EQ(language->say("tool.spoon"), "[tool.spoon]") << "nor has the program it";
}

TEST_F(LanguageTest, tenths_stand_behind_what_the_file_says) {
  const auto read = [&](const std::string& line) {
    return check_language(write(
        "de.toml", "code = \"de\"\nname = \"Deutsch\"\n" + line + "[text]\nplain = \"Gefäß\"\n"));
  };
  EXPECT_EQ(read("").language.decimal(), ".");
  EXPECT_EQ(read("decimal = \",\"\n").language.decimal(), ",");
  const auto wrong = read("decimal = \"and\"\n");
  ASSERT_EQ(wrong.problems.size(), 1u);
  EXPECT_NE(to_text(wrong.problems[0]).find("de.toml:3:11"), std::string::npos)
      << to_text(wrong.problems[0]);
}

TEST_F(LanguageTest, dotted_keys_need_no_quotes) {
  const auto language =
      Language::read(write("en.toml",
                           "code = \"en\"\nname = \"English\"\n[text]\nalike.belly = \"belly\"\n"
                           "[text.remark]\nneck.wide = \"neck\"\n"));
  ASSERT_TRUE(language) << to_text(language.error());
  EXPECT_EQ(language->say("alike.belly"), "belly");
  EXPECT_EQ(language->say("remark.neck.wide"), "neck");
}

TEST_F(LanguageTest, what_is_wrong_is_said_with_its_line) {
  const auto read = check_language(
      write("en.toml", "code = \"fr\"\n[text]\na = \"{mm\"\nb = \"mm}\"\nc = 3\nd = \"\"\n"));
  std::string all;
  for (const Problem& p : read.problems) all += to_text(p) + "\n";
  for (const char* words :
       {"en.toml:1:8", "name is missing", "no } after", "no { before", "c is 3", "d is empty"})
    EXPECT_NE(all.find(words), std::string::npos) << words << " in\n" << all;
}

TEST_F(LanguageTest, what_differs_from_the_programs_english_is_named_and_still_spoken) {
  const std::string english = files::test::content("content/languages/en.toml");
  const auto changed = [&](const std::string& what, const std::string& with) {
    std::string text = english;
    text.replace(text.find(what), what.size(), with);
    const auto read = check_language(write("en.toml", text));
    EXPECT_TRUE(read.problems.empty()) << to_text(read.problems[0]);
    EXPECT_TRUE(Language::read(folder_ / "en.toml"));
    std::string all;
    for (const Problem& p : read.advice) all += to_text(p) + "\n";
    EXPECT_EQ(read.advice.size(), all.empty() ? 0u : 1u) << all;
    return all;
  };
  EXPECT_EQ(changed("Touch to begin", "Begin here"), "");
  const std::pair<std::pair<const char*, const char*>, std::vector<const char*>> slips[] = {
      {{"begin = \"Touch to begin\"\n", ""},
       {"en.toml:14:", "attract.begin is missing", "begin = \"Touch to begin\""}},
      {{"begin = ", "beginn = "}, {"attract.beginn", "Did you mean attract.begin?"}},
      {{"help = \"Help\"\n", "help = \"Help\"\nnonsense = \"x\"\n"}, {"all.nonsense", "Remove it"}},
      {{"rpm = \"{rpm} rpm\"", "rpm = \"{turns} rpm\""}, {"{turns}", "Its placeholders are {rpm}"}},
      {{"rpm = \"{rpm} rpm\"", "rpm = \"turning\""}, {"throw.rpm lacks {rpm}"}},
      {{"back = \"Back\"", "back = \"Back, and then some more words than a button has\""},
       {"all.back has 48 letters, but there is room for only 28"}},
      {{"back = \"Back\"", "back = \"Ba\\u001bck\""}, {"control character U+001B"}},
      {{"back = \"Back\"", "back = \"{way} back\""}, {"{way}", "Remove the braces"}}};
  for (const auto& [slip, words] : slips) {
    const std::string all = changed(slip.first, slip.second);
    for (const char* word : words)
      EXPECT_NE(all.find(word), std::string::npos) << word << " in\n" << all;
  }
}

TEST_F(LanguageTest, a_copy_that_nobody_translated_is_named) {
  const std::string english = files::test::content("content/languages/en.toml");
  const auto advice_of = [&](const std::string& code) {
    std::string text = english;
    text.replace(text.find("code = \"en\""), 11, "code = \"" + code + "\"");
    return check_language(write(code + ".toml", text)).advice;
  };
  const auto dutch = advice_of("nl");
  ASSERT_EQ(dutch.size(), 1u);
  EXPECT_NE(dutch[0].what.find("longer texts are still in English"), std::string::npos)
      << dutch[0].what;
  EXPECT_TRUE(advice_of("en-GB").empty());
}

TEST_F(LanguageTest, no_language_that_comes_with_the_exhibit_is_a_copy) {
  for (const auto& file : std::filesystem::directory_iterator("content/languages"))
    EXPECT_TRUE(check_language(file.path()).advice.empty()) << file.path();
}

TEST_F(LanguageTest, a_key_below_the_wrong_table_is_sent_to_the_right_one) {
  // The first is spelt nearly so; the second is only known by its last part.
  const std::pair<std::string, std::string> moves[] = {{"choose.reduced", "throw.reduced"},
                                                       {"throw.rpm", "attract.rpm"}};
  for (const auto& [right, wrong] : moves) {
    std::string text = files::test::content("content/languages/ko.toml");
    const std::string key = right.substr(right.find('.') + 1);
    const std::size_t from = text.find("\n" + key + " = ") + 1, to = text.find('\n', from) + 1;
    const std::string line = text.substr(from, to - from);
    text.erase(from, to - from);
    const std::string table = "[text." + wrong.substr(0, wrong.find('.')) + "]";
    text.insert(text.find('\n', text.find(table)) + 1, line);
    const auto read = check_language(write("ko.toml", text));
    ASSERT_EQ(read.advice.size(), 1u);
    EXPECT_NE(read.advice[0].what.find(wrong), std::string::npos) << read.advice[0].what;
    EXPECT_NE(read.advice[0].remedy.find(right), std::string::npos) << read.advice[0].remedy;
  }
}

}  // namespace
}  // namespace onggi::content::language_test
