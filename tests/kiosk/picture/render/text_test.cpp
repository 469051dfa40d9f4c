#include "kiosk/picture/render/text.h"

#include "kiosk/picture/view/palette.h"
#include "tests/kiosk/picture/render/studio_fixture.h"

namespace onggi::render::testing::text_test {
namespace {

TEST(Typesetter, SetsEverySentenceOnWholeLines) {
  const Typesetter type;
  const view::TextStyle style{.px = 30, .line_height = 1.4f};
  const auto one = type.measure("A pot", style, 0);
  EXPECT_FLOAT_EQ(one.height, 42.0f);
  const auto many =
      type.measure("A pot that was thrown on a wheel and dried in the sun.", style, 260);
  EXPECT_LE(many.width, 260.0f);
  EXPECT_GT(many.height, 42.0f);
  EXPECT_FLOAT_EQ(many.height / 42.0f, std::round(many.height / 42.0f));
}

TEST(Typesetter, KeepsTheLineHeightInEveryScript) {
  const Typesetter type;
  for (const char* text : {"Pot", "\xEB\x8F\x84\xEC\x9E\x90\xEA\xB8\xB0", "\xE5\xA3\xBA",
                           "\xD8\xAC\xD8\xB1\xD8\xA9", "\xD7\x9B\xD7\x93"}) {
    const auto size = type.measure(text, {.px = 30, .line_height = 1.4f}, 0);
    EXPECT_FLOAT_EQ(size.height, 42.0f) << text;
    EXPECT_GT(size.width, 10.0f) << text;
  }
}

TEST(Typesetter, AParagraphOfAnyLengthIsShapedAsOneOfFourThousandBytes) {
  const Typesetter type;
  const view::TextStyle style{.px = 20, .line_height = 1.4f};
  for (const char* letter : {"a ", "m", "\u78c1", "\u062c"}) {
    std::string text;
    while (text.size() < 100000) text += letter;
    std::string most = text.substr(0, Typesetter::kMostBytes / 12 * 12);
    const float lines = type.measure(text, style, 400).height / 28.0f;
    EXPECT_GE(lines, type.measure(most, style, 400).height / 28.0f) << letter;
    EXPECT_LE(lines, type.measure(most, style, 400).height / 28.0f + 2) << letter;
  }
}

TEST(Typesetter, ALongWordBreaksAfterFortyLettersSoThatItsTimeGrowsWithItsLengthAlone) {
  const Typesetter type;
  const view::TextStyle style{.px = 20, .line_height = 1.4f};
  const float forty = type.measure(std::string(40, 'm'), style, 0).width;
  EXPECT_FLOAT_EQ(type.measure(std::string(41, 'm'), style, forty * 1.02f).width, forty);
  EXPECT_FLOAT_EQ(type.measure(std::string(200, 'm'), style, forty * 1.02f).height, 5 * 28.0f);
}

TEST(Typesetter, NumbersAreTabular) {
  const Typesetter type;
  EXPECT_EQ(type.measure("1111", {.px = 40}, 0).width, type.measure("8888", {.px = 40}, 0).width);
}

TEST(Typesetter, AFigureAndItsUnitStandInOneLine) {
  const Typesetter type;
  const view::TextStyle style{.px = 30};
  const auto set = [&](const std::string& before, const std::string& rest) {
    // Room for what stands before and for the figure, and not for its unit.
    const float room = type.measure(before + " 30.5", style, 0).width + 4;
    return type.measure(before + " " + rest, style, room);
  };
  const float line = type.measure("x", style, 0).height;
  for (const char* unit : {"cm", "mm", "l", "%", "سم"}) {
    const std::string figure = std::string("30.5 ") + unit;
    EXPECT_NEAR(set("Moon jar, 18th century,", figure).height, 2 * line, 0.1f * line) << unit;
    EXPECT_LT(set("Moon jar, 18th century,", figure).width,
              type.measure("Moon jar, 18th century, 30.5", style, 0).width - 20)
        << unit;
  }
  // A word that only begins like one is a word.
  EXPECT_GT(set("Moon jar, 18th century,", "30.5 slow").width,
            type.measure("Moon jar, 18th century,", style, 0).width + 20);
}

TEST(Typesetter, KoreanWordsAreNotBroken) {
  const Typesetter type;
  const view::TextStyle style{.px = 30, .language = "ko"};
  const std::string word = "\xEB\xAC\xBC\xEB\xA0\x88\xEB\xA1\x9C";  // three syllables
  const auto alone = type.measure(word, style, 0);
  // Room for a word and a half: the second word goes to the next line whole.
  const auto two = type.measure(word + " " + word, style, alone.width * 1.6f);
  EXPECT_NEAR(two.width, alone.width, 12.0f);
  EXPECT_FLOAT_EQ(two.height, 2 * alone.height);
}

TEST(Typesetter, AListInChineseOrJapaneseBreaksAfterItsCommas) {
  const Typesetter type;
  for (const char* language : {"ja", "zh"}) {
    const view::TextStyle style{.px = 30, .language = language};
    const std::string first = "江戸時代、", second = "大和文華館";
    const auto alone = type.measure(second, style, 0);
    // Room for one part and a half: the second goes to the next line whole.
    const auto both = type.measure(first + second, style, alone.width * 1.5f);
    EXPECT_FLOAT_EQ(both.height, 2 * alone.height);
    EXPECT_NEAR(both.width, alone.width, 12.0f) << language;
  }
}

TEST(Typesetter, AndBeforeWhatStandsInBrackets) {
  const Typesetter type;
  for (const char* language : {"ja", "zh"}) {
    const view::TextStyle style{.px = 30, .language = language};
    const std::string first = "朝鮮時代", second = "（日本で使用）";
    const auto alone = type.measure(second, style, 0);
    const auto both = type.measure(first + second, style, alone.width * 1.3f);
    EXPECT_FLOAT_EQ(both.height, 2 * alone.height);
    EXPECT_NEAR(both.width, alone.width, 12.0f) << language;
  }
}

TEST(Typesetter, RunningTextInChineseOrJapaneseFillsItsLines) {
  const Typesetter type;
  const view::TextStyle style{.px = 30, .language = "ja"};
  std::string words;
  for (int i = 0; i < 12; ++i) words += "江戸時代大和文華館、";
  const auto size = type.measure(words, style, 420);
  EXPECT_GT(size.width, 385.0f);
}

TEST(Typesetter, ALetterThatNoFontHasIsOneBox) {
  const Typesetter type;
  for (const char* language : {"en", "ko", "ja", "ar"}) {
    const view::TextStyle style{.px = 30, .language = language};
    const float box = type.measure("Jar \u25A1", style, 0).width;
    // For private use, and of a plane without writings.
    for (const char* none : {"\U000F0000", "\U0003FFF0", "\U000FABCD"})
      EXPECT_FLOAT_EQ(type.measure(std::string("Jar ") + none, style, 0).width, box) << language;
  }
}

TEST(Typesetter, WhatHasNoInkIsNoBox) {
  const Typesetter type;
  const view::TextStyle style{.px = 30};
  const auto plain = type.measure("Jar", style, 0);
  for (const char* unseen : {"\u200B", "\u2060", "\uFE0F", "\U000E0100", "\U000E0041"})
    EXPECT_FLOAT_EQ(type.measure(std::string("Ja") + unseen + "r", style, 0).width, plain.width)
        << unseen;
}

using TextOnScreen = StudioTest;

TEST_F(TextOnScreen, AParagraphFromTheRightStaysOneWhateverItBeginsWith) {
  const auto left_ink = [&](bool right_to_left) {
    view::Frame frame;
    frame.width = 600;
    frame.height = 100;
    view::Text text;
    text.box = {0, 20, 600, 60};
    text.text = "STL \xD8\xAC\xD8\xB1\xD8\xA9";
    text.style = {.px = 40, .language = "ar", .right_to_left = right_to_left};
    text.color = view::kInk;
    frame.items.emplace_back(text);
    renderer().draw(frame);
    const view::Image image = renderer().read_pixels();
    for (int x = 0; x < 600; ++x)
      for (int y = 20; y < 80; ++y)
        if (pixel_at(image, x, y).r < 120) return x;
    return 600;
  };
  EXPECT_LT(left_ink(false), 40) << "by its first letter";
  EXPECT_GT(left_ink(true), 300);
}

TEST_F(TextOnScreen, RightToLeftStartsAtTheRight) {
  view::Frame frame;
  frame.width = 600;
  frame.height = 100;
  view::Text text;
  text.box = {0, 20, 600, 60};
  text.text = "\xD8\xAC\xD8\xB1\xD8\xA9";
  text.style = {.px = 40, .language = "ar"};
  text.color = view::kInk;
  frame.items.emplace_back(text);
  renderer().draw(frame);
  const view::Image image = renderer().read_pixels();
  int left = 0, right = 0;
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 300; ++x) {
      left += pixel_at(image, x, y).r < 128 ? 1 : 0;
      right += pixel_at(image, x + 300, y).r < 128 ? 1 : 0;
    }
  }
  EXPECT_EQ(left, 0);
  EXPECT_GT(right, 100);
}

TEST_F(TextOnScreen, WhatDoesNotFitIsDrawnAndCounted) {
  view::Frame frame;
  frame.width = 400;
  frame.height = 200;
  view::Text text;
  text.box = {10, 10, 120, 30};
  text.text = "Far too much for one line of this box";
  text.style = {.px = 24};
  text.color = view::kInk;
  frame.items.emplace_back(text);
  const std::uint64_t before = renderer().status().text_overflows;
  renderer().draw(frame);
  EXPECT_EQ(renderer().status().text_overflows, before + 1);
  EXPECT_EQ(renderer().status().last_overflow, text.text);
}

}  // namespace
}  // namespace onggi::render::testing::text_test
