#include "kiosk/visit/screens/label.h"

#include <gtest/gtest.h>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::label_test {
namespace {

content::Language language(const std::string& code) {
  auto read = content::Language::read("content/languages/" + code + ".toml");
  EXPECT_TRUE(read) << (read ? "" : to_text(read.error()));
  return read ? *read : content::Language{};
}

TEST(Label, TenthsStandBehindThePointOrTheCommaOfTheLanguage) {
  EXPECT_EQ(centimetres(0.305, language("en")), "30.5");
  EXPECT_EQ(centimetres(0.305, language("ko")), "30.5");
  for (const char* code : {"de", "es", "fr"})
    EXPECT_EQ(centimetres(0.305, language(code)), "30,5") << code;
  EXPECT_EQ(centimetres(0.30, language("de")), "30");
  EXPECT_EQ(centimetres(0.0049, language("en")), "0.5");
  EXPECT_EQ(centimetres(1.2996, language("en")), "130");
}

TEST(Label, WhatIsListedHasTheCommaOfItsWriting) {
  const auto line = [](const char* code, const char* culture, const char* date) {
    content::Label label;
    label.culture = culture;
    label.date = date;
    return label_line(label, language(code));
  };
  EXPECT_EQ(line("en", "Korea", "18th century"), "Korea, 18th century");
  EXPECT_EQ(line("ja", "日本", "江戸時代"), "日本、江戸時代");
  EXPECT_EQ(line("zh", "中国", "明代"), "中国，明代");
  EXPECT_EQ(line("ar", "مصر", "القرن"), "مصر، القرن");
  EXPECT_EQ(line("ja", "日本", ""), "日本");
  EXPECT_EQ(line("ja", "", "江戸時代"), "江戸時代");
}

TEST(Label, SentencesStandApartOnlyWhereTheWritingHasSpaces) {
  EXPECT_EQ(joined("One.", "Two."), "One. Two.");
  EXPECT_EQ(joined("一。", "二。"), "一。二。");
  EXPECT_EQ(joined("一！", "二？"), "一！二？");
  EXPECT_EQ(joined("", "二。"), "二。");
  EXPECT_EQ(sentences("一。二！三？四"), (std::vector<std::string>{"一。", "二！", "三？", "四"}));
  EXPECT_EQ(sentences("One. Two? 3.5 mm! Four"),
            (std::vector<std::string>{"One.", "Two?", "3.5 mm!", "Four"}));
}

/// What a label says of a vessel of 30.5 cm that is thrown smaller.
std::string label_in(const char* code) {
  Visitor v(2);
  v.languages = {language(code)};
  for (content::Vessel& vessel : v.vessels)
    vessel.labels[code] = {"T", "C", "D", "M。", "一。二。", ""};
  v.show();
  v.down(600, 300), v.up(600, 300);
  v.show();
  v.touch("choose.card.0");
  v.frames(1);
  return words_in(v.frame);
}

TEST(Label, NoLatinStopStandsBetweenChineseOrJapaneseSentences) {
  EXPECT_NE(label_in("ja").find("C、D。高さ"), std::string::npos) << label_in("ja");
  EXPECT_NE(label_in("zh").find("C，D。高"), std::string::npos) << label_in("zh");
  EXPECT_NE(label_in("ja").find("一。二。"), std::string::npos);
  EXPECT_NE(label_in("de").find("C, D. 30,5"), std::string::npos) << label_in("de");
}

TEST(Label, EachLanguagesNameIsSetInItsOwnLanguage) {
  Visitor v(2);
  v.languages = {language("ko"), language("ja"), language("zh"), language("ar")};
  v.show();
  v.touch("language");
  v.frames(1);
  int seen = 0;
  for (const view::Item& item : v.frame.items)
    if (const auto* text = std::get_if<view::Text>(&item))
      for (const content::Language& other : v.languages)
        if (text->text == other.name()) {
          EXPECT_EQ(text->style.language, other.code());
          ++seen;
        }
  EXPECT_EQ(seen, 4);
}

TEST(Label, ASwitchReadFromTheRightHasItsFirstHalfAtTheRight) {
  for (const char* code : {"en", "ar"}) {
    Visitor v(2);
    v.languages = {language(code), language("ko")};
    v.show();
    v.touch("comfort");
    v.frames(1);
    std::optional<float> on, off;
    for (const view::Item& item : v.frame.items)
      if (const auto* text = std::get_if<view::Text>(&item)) {
        if (!off && text->text == v.languages[0].say("comfort.off")) off = text->box.x;
        if (!on && text->text == v.languages[0].say("comfort.on")) on = text->box.x;
      }
    ASSERT_TRUE(on && off);
    EXPECT_EQ(*off < *on, code == std::string("en")) << code;
  }
}

TEST(Label, WordsOfALanguageReadFromTheRightAreSetSoWhateverTheyBeginWith) {
  Visitor v(2);
  v.languages = {language("ar"), language("en")};
  v.show();
  for (const view::Item& item : v.frame.items)
    if (const auto* text = std::get_if<view::Text>(&item)) {
      EXPECT_TRUE(text->style.right_to_left) << text->text;
    }
  v.speak("en");
  v.frames(1);
  for (const view::Item& item : v.frame.items)
    if (const auto* text = std::get_if<view::Text>(&item)) {
      EXPECT_FALSE(text->style.right_to_left) << text->text;
    }
}

TEST(Label, TheNameOfAKeepsakeIsReadFromTheLeftInArabicToo) {
  Visitor v(2);
  v.languages = {language("ar")};
  v.make_result();
  v.touch("result.keep");
  v.visit->show_postcard(9);
  v.visit->keepsake_kept("2026-05-04_141503");
  v.frames(1);
  EXPECT_NE(words_in(v.frame).find("\u20682026-05-04_141503\u2069"), std::string::npos);
}

}  // namespace
}  // namespace onggi::screens::label_test
