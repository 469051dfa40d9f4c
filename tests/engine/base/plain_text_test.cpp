#include "engine/base/plain_text.h"

#include <gtest/gtest.h>

#include "engine/base/result.h"

namespace onggi::terminal::plain_text_test {
namespace {

TEST(PlainText, WordsOfAnyLanguageStayAsTheyAre) {
  for (const char* words :
       {"", "Moon jar, 30.5 cm", "달항아리", "Ölkännchen", "إبريق", "𒀭 🏺", "⌀ 12"})
    EXPECT_EQ(plain(words), words);
}

TEST(PlainText, WhatCommandsATerminalBecomesAQuestionMark) {
  EXPECT_EQ(plain("\x1b[31mred\x1b[0m"), "?[31mred?[0m");
  EXPECT_EQ(plain("jar\r\nAll good\t\b\x7f"), "jar??All good???");
  EXPECT_EQ(plain("\xC2\x9B"
                  "31m"),
            "?31m");  // the same as escape and [, in one character
  EXPECT_EQ(plain("\xE2\x80\xAE"
                  "gnp.jar"),
            "?gnp.jar");  // read from right to left
  EXPECT_EQ(plain(std::string_view("a\0b", 3)), "a?b");
}

TEST(PlainText, BytesThatAreNoUtf8BecomeOneQuestionMarkEach) {
  EXPECT_EQ(plain("\xFF\xFE"), "??");
  EXPECT_EQ(plain("\xE2\x80"), "??");            // cut off
  EXPECT_EQ(plain("\xC0\x9B"), "??");            // longer than it need be
  EXPECT_EQ(plain("\xED\xA0\x80"), "???");       // half of a pair
  EXPECT_EQ(plain("\xF5\x80\x80\x80"), "????");  // beyond the last character
}

TEST(PlainText, AProblemIsTwoLinesWhateverItsFileIsCalled) {
  const Problem evil{"jar\n\x1b[2J.glb", "its node \"\x1b]0;x\a\" is\nodd.", "Rename\nit."};
  EXPECT_EQ(to_text(evil), "jar??[2J.glb: its node \"?]0;x?\" is?odd.\n  Rename?it.");
}

TEST(PlainText, AColumnIsAsWideAsItIsSeenAndNeverCutsACharacter) {
  EXPECT_EQ(column("moon_jar", 10), "moon_jar  ");
  EXPECT_EQ(column("moon_jar", 4), "moon");
  EXPECT_EQ(column("달항아리", 10), "달항아리  ") << "two columns each";
  EXPECT_EQ(column("달항아리", 5), "달항 ") << "half a character is a blank";
  EXPECT_EQ(column("Ölkännchen", 10), "Ölkännchen");
  EXPECT_EQ(column("a\u0308b", 2), "a\u0308b") << "a mark stands on its letter";
  EXPECT_EQ(column("🏺.", 3), "🏺.");
  EXPECT_EQ(column("\x1b[31m", 3), "?[3");
  EXPECT_EQ(column("", 2), "  ");
  EXPECT_EQ(column("jar", 0), "");
}

TEST(PlainText, ColumnsAreCountedAsTheyAreSet) {
  EXPECT_EQ(columns("jar"), 3u);
  EXPECT_EQ(columns("달항아리"), 8u);
  EXPECT_EQ(columns("a\u0308b"), 2u);
  EXPECT_EQ(columns("\xff磁"), 3u) << "a byte that is no UTF-8 is one question mark";
}

}  // namespace
}  // namespace onggi::terminal::plain_text_test
