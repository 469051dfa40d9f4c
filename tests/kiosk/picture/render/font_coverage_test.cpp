#include "kiosk/picture/render/font_coverage.h"

#include <gtest/gtest.h>

#include <string>

namespace onggi::render::font_coverage_test {
namespace {

using Letters = std::vector<char32_t>;

TEST(FontCoverage, TheWritingsOfTheExhibitHaveFonts) {
  const FontCoverage& fonts = FontCoverage::here();
  for (const char* text : {"Moon jar", "달항아리", "満月壺", "月光瓶", "جرة القمر", "כד ירח", "ไห"})
    EXPECT_TRUE(fonts.missing_in(text).letters.empty()) << text;
}

TEST(FontCoverage, NamesEachLetterThatNoFontHasOnceAndSaysWhetherThatIsAll) {
  const FontCoverage& fonts = FontCoverage::here();
  const auto some = fonts.missing_in("A \U000F0001\U000F0000\U000F0001 jar");
  EXPECT_EQ(some.letters, (Letters{0xF0001, 0xF0000}));
  EXPECT_FALSE(some.all);
  const auto all = fonts.missing_in(" \U000F0001 \U000F0000 \u200B");
  EXPECT_EQ(all.letters, (Letters{0xF0001, 0xF0000}));
  EXPECT_TRUE(all.all);
}

TEST(FontCoverage, WhatHasNoInkNeedsNoFont) {
  const FontCoverage& fonts = FontCoverage::here();
  for (const char* text : {"", "\n\t ", "\u200E\u200F\u2060", "\uFE0F", "\U000E0041", "\u2028"}) {
    const auto missing = fonts.missing_in(text);
    EXPECT_TRUE(missing.letters.empty()) << text;
    EXPECT_FALSE(missing.all) << text;
  }
}

TEST(FontCoverage, ALetterOfPartsThatFontsHaveIsDrawnOfItsParts) {
  const FontCoverage only = FontCoverage::of({U'e', 0x301, 0x25A1});
  EXPECT_TRUE(only.missing_in("\u00E9").letters.empty());
  EXPECT_EQ(only.missing_in("\u00E8").letters, (Letters{0xE8}));
}

TEST(FontCoverage, ABoxStandsForEachLetterThatNoFontHas) {
  const FontCoverage only = FontCoverage::of({U'a', 0x25A1});
  EXPECT_EQ(only.boxed("ab\na\u200Bb"), "a\u25A1\na\u200B\u25A1");
  // Where nothing has ink and no font has it, nothing stands.
  EXPECT_EQ(only.boxed("a\u3164a"), "aa");
  EXPECT_EQ(FontCoverage::of({U'a', U'?'}).boxed("ab"), "a?");
}

}  // namespace
}  // namespace onggi::render::font_coverage_test
