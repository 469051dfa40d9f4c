#include "kiosk/collection/settings/visitor_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace onggi::settings::visitor_text_test {
namespace {

using ::testing::HasSubstr;

std::string times(int n, const std::string& text) {
  std::string out;
  for (int i = 0; i < n; ++i) out += text;
  return out;
}

std::string fault(const std::string& text, TextBound bound) {
  const auto found = fault_of(text, "title", bound);
  return found ? found->what + " " + found->remedy : "";
}

TEST(VisitorText, AsManyLettersAsTheBoundAreGoodInAnyWritingAndOneMoreIsCounted) {
  for (const char* letter : {"a ", "é ", "항", "ج ", "😀"}) {
    const std::string text = times(letters(letter) == 2 ? 20 : 40, letter);
    EXPECT_EQ(fault(text, {40}), "") << letter;
    EXPECT_THAT(fault(text + "x", {40}), HasSubstr("41 letters, but there is room for only 40"));
  }
}

TEST(VisitorText, WhereAWideLetterCountsTwiceHalfAsManyAreGood) {
  constexpr TextBound kBound{60, false, true};
  for (const char* wide : {"磁", "あ", "항"}) {
    EXPECT_EQ(fault(times(30, wide), kBound), "");
    EXPECT_THAT(fault(times(31, wide), kBound),
                HasSubstr("62 letters, but there is room for only"));
    EXPECT_THAT(fault(times(31, wide), kBound), HasSubstr("counts as two"));
    EXPECT_EQ(fitted(times(31, wide), kBound), times(29, wide) + "…");
  }
  EXPECT_EQ(fault(times(30, "a "), kBound), "");
  EXPECT_THAT(fault("e" + times(5000, "\u0301"), kBound), HasSubstr("5001 letters")) << "no width";
}

TEST(VisitorText, AWordOfMoreThanFortyLettersIsSaidWhereTheWritingHasSpaces) {
  EXPECT_EQ(fault(times(40, "m"), {900}), "");
  EXPECT_THAT(fault(times(41, "m"), {900}), HasSubstr("a word of 41 letters"));
  EXPECT_THAT(fault("a " + times(41, "ж") + " b", {900}), HasSubstr("a word of 41 letters"));
  EXPECT_EQ(fault(times(20, "word-word/"), {900}), "");
  for (const char* anywhere : {"磁", "あ", "항", "ก"})
    EXPECT_EQ(fault(times(200, anywhere), {900}), "") << anywhere;
}

TEST(VisitorText, ATextOfWhichNothingIsSeenIsNamed) {
  for (const char* unseen : {"\u200b\u200b", "\u3164", " \u00a0 ", "\u2800", "\ufeff", "\U000e0041",
                             "\u115f\u1160", "\u2061"}) {
    EXPECT_TRUE(is_blank(unseen));
    EXPECT_THAT(fault(unseen, {60}), HasSubstr("nobody can see"));
  }
  EXPECT_THAT(fault("  ", {60}), HasSubstr("is empty"));
  EXPECT_THAT(fault("", {60}), HasSubstr("is empty"));
  for (const char* seen : {"a", "م", "\u200bx", "·"}) EXPECT_FALSE(is_blank(seen)) << seen;
}

TEST(VisitorText, ControlCharactersAreNamedAndLineBreaksStandOnlyInParagraphs) {
  EXPECT_THAT(fault(std::string("a\0b", 3), {60}), HasSubstr("control character U+0000"));
  EXPECT_THAT(fault("a\x1b[31m", {60, true}), HasSubstr("control character U+001B"));
  EXPECT_THAT(fault("a\u0085", {60}), HasSubstr("control character U+0085"));
  EXPECT_THAT(fault("two\nlines", {60}), HasSubstr("line break or tab"));
  EXPECT_EQ(fault("two\r\nlines\tfar", {60, true}), "");
}

TEST(VisitorText, WhatTurnsTheDirectionOfWritingOrBreaksALineUnseenIsNamedWithItsCode) {
  EXPECT_THAT(fault("jar\u202Exet.toml", {60, true}),
              HasSubstr("control character U+202E (it turns the direction of writing)"));
  for (const char* turns :
       {"\u202A", "\u202B", "\u202C", "\u202D", "\u2066", "\u2067", "\u2068", "\u2069"})
    EXPECT_THAT(fault(std::string("a") + turns + "b", {60}), HasSubstr("turns the direction"));
  for (const char* breaks : {"\u2028", "\u2029"})
    EXPECT_THAT(fault(std::string("a") + breaks + "b", {60, true}),
                HasSubstr("(it breaks a line)"));
  EXPECT_EQ(fitted("a\u202Eb", {60}), "a b");
  // Marks beside a number or a bracket are good Arabic and Hebrew.
  for (const char* mark : {"\u200E", "\u200F", "\u061C"})
    EXPECT_EQ(fault(std::string("جرة") + mark + " (A)", {60}), "");
}

TEST(VisitorText, WhatIsFittedHasNoFaultOfLengthOrControlAndStaysWhereItFits) {
  EXPECT_EQ(fitted("Moon jar", {60}), "Moon jar");
  EXPECT_EQ(fitted("Moon jar", {5}), "Moon…");
  EXPECT_EQ(fitted("달항아리", {3}), "달항…");
  EXPECT_EQ(fitted("a\x1b[31m\nb", {60}), "a [31m b");
  EXPECT_EQ(fitted("a\nb", {60, true}), "a\nb");
  for (std::size_t most = 1; most < 8; ++most) {
    const std::string text = fitted("e\u0301 磁\u0007😀 و", {most});
    EXPECT_LE(letters(text), most);
    EXPECT_EQ(fault(text, {most}), "") << text;
  }
}

TEST(VisitorText, ALongWordGetsABreakEachFortyLettersAndOtherTextsStay) {
  for (const char* text :
       {"", "A moon jar.", "달항아리", "https://a.museum/a/very/long/way/to/a/jar"})
    EXPECT_EQ(with_breaks(text), text);
  EXPECT_EQ(with_breaks(times(40, "é")), times(40, "é"));
  EXPECT_EQ(with_breaks(times(81, "é")), times(40, "é") + "\u200b" + times(40, "é") + "\u200bé");
  EXPECT_EQ(with_breaks(times(300, "磁")), times(300, "磁"));
}

TEST(VisitorText, ATranslationMayHaveTwiceTheLettersOfTheEnglishAndTwenty) {
  EXPECT_EQ(bound_beside("Back").letters, 28u);
  EXPECT_EQ(bound_beside("").letters, 20u);
}

}  // namespace
}  // namespace onggi::settings::visitor_text_test
