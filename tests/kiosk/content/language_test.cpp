#include "kiosk/content/language.h"

#include "tests/kiosk/content/temporary.h"

namespace onggi::content {
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

}  // namespace
}  // namespace onggi::content
