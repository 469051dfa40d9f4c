#include "kiosk/visit/screens/measuring.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::measuring_test {
namespace {

/// A text of sentences of one letter each, as long as a label may be: each sentence is measured
/// with all before it.
std::string hardest(int sentences) {
  std::string text;
  for (int i = 0; i < sentences; ++i) text += "\u3042\u3002";
  return text;
}

TEST(Measuring, NoFrameMeasuresMoreThanItsShareWhateverAVesselSays) {
  for (const int sentences : {450, 4000}) {
    Visitor v(2);
    for (content::Vessel& vessel : v.vessels)
      vessel.labels["en"] = {hardest(30),        hardest(40),        hardest(30),
                             hardest(sentences), hardest(sentences), hardest(sentences)};
    v.show();
    v.touch("attract.begin");
    v.touch("choose.card.0");
    v.frames(3);
    const std::size_t longest = 6u * static_cast<std::size_t>(sentences) + 1000;
    EXPECT_LE(v.most_measured, Measuring::kMostBytes + longest) << sentences;
    if (sentences == 4000) {
      EXPECT_GT(v.most_measured, Measuring::kMostBytes / 2) << "this label asks for it";
    }
  }
}

/// Sets nothing, and counts the writings of each size of a font that were not asked for before.
class CountedFonts final : public view::TextMeasure {
 public:
  Size measure(const std::string& text, const view::TextStyle& style, float) const override {
    ++texts;
    std::size_t of = 0;
    for (const char* letter : {"a", "\u0639", "\uac00", "\u0e01", "\U00012000"})
      of += text.find(letter) != std::string::npos ? 1 : 0;
    if (sizes.insert(style.px).second) writings += of;
    return {1, 1};
  }
  mutable std::set<float> sizes;
  mutable std::size_t writings = 0, texts = 0;
};

// A letter that the first families lack is looked for in every font of the machine, and again for
// each size: 5 to 7 ms for these five writings, however short their text.
TEST(Measuring, NoFrameLooksForLettersInMoreFontsThanItsShare) {
  CountedFonts fonts;
  Measuring measuring(fonts);
  int frames = 0;
  for (bool all = false; !all; ++frames) {
    ASSERT_LT(frames, 100);
    measuring.begin_frame();
    const std::size_t before = fonts.writings;
    for (int n = 0; n < 100; ++n)
      (void)measuring("a \u0639 \uac00 \u0e01 \U00012000", {.px = 10.0F + static_cast<float>(n)},
                      0);
    EXPECT_LE(fonts.writings - before, 80u) << "frame " << frames;
    all = !measuring.spent();
  }
  EXPECT_EQ(fonts.texts, 100u) << "each once";
  // The last ones cost nothing more; the first were dropped.
  const auto again = [&](float first) {
    measuring.begin_frame();
    for (int n = 0; n < 10; ++n)
      (void)measuring("\uac00 a", {.px = first + static_cast<float>(n)}, 0);
    return measuring.bytes();
  };
  EXPECT_LT(again(100), 10u * (2 * Measuring::kEach + 10));
  EXPECT_GE(again(10), 20u * Measuring::kWriting);
}

TEST(Measuring, AFewFramesLaterEveryTextHasItsTrueSize) {
  Visitor v(2);
  for (content::Vessel& vessel : v.vessels)
    vessel.labels["en"] = {"Jar", "Here", "Now", "Thrown.", hardest(450), "Us"};
  v.show();
  v.touch("attract.begin");
  v.touch("choose.card.0");
  v.frames(4);
  v.counting->asked = 0;
  v.frame = v.visit->frame(v.width, v.height);
  EXPECT_EQ(v.counting->asked, 0u) << "all is known";
  EXPECT_TRUE(v.visit->control("choose.throw"));
}

TEST(Measuring, AShelfOfAThousandVesselsIsMeasuredOnceAndNotInEveryFrame) {
  Visitor v(1000);
  for (std::size_t n = 0; n < v.vessels.size(); ++n) {
    const std::string name = "Jar number " + std::to_string(n);
    v.vessels[n].labels["en"] = {name, "Somewhere " + std::to_string(n), "Then", "", "", ""};
  }
  v.show();
  v.touch("attract.begin");
  v.frames(1);
  EXPECT_LE(v.most_measured, Measuring::kMostBytes + 1000);
  v.counting->asked = 0;
  v.frame = v.visit->frame(v.width, v.height);
  EXPECT_EQ(v.counting->asked, 0u);
}

// Frames of 0.5 to 1.1 s: such texts take ten times as long for each byte.
TEST(Measuring, ATextThatMixesEveryWritingCountsForMore) {
  const PlainMeasure plain;
  const view::TextStyle style{.px = 20};
  const auto counted = [&](const std::string& word) {
    Measuring measuring(plain);
    measuring.begin_frame();
    std::string text;
    while (text.size() < 1000) text += word;
    text.resize(1000, ' ');
    measuring(text, style, 300);
    return measuring.bytes();
  };
  constexpr std::size_t kOne = 1000 + Measuring::kEach + Measuring::kWriting;
  EXPECT_EQ(counted("\uc774 \ud56d\uc544\ub9ac, "), kOne);
  EXPECT_EQ(counted("Th\u00e9i\u00e8re de 1900, "), kOne);
  EXPECT_GT(counted("\u0639 \u05e9 b \u845b \u0e01 "), 5000u + 5 * Measuring::kWriting);
}

TEST(Measuring, ANewTextOfAFrameThatHasMeasuredItsShareIsGuessedAndMeasuredInTheNext) {
  const PlainMeasure plain;
  const CountingMeasure counting(plain);
  Measuring measuring(counting);
  const view::TextStyle style{.px = 20};
  measuring.begin_frame();
  measuring(std::string(Measuring::kMostBytes, 'x'), style, 300);
  EXPECT_TRUE(measuring.spent());
  const std::size_t asked = counting.asked;
  const auto guess = measuring("A pot", style, 300);
  EXPECT_GT(guess.width, 0.0f);
  EXPECT_GT(guess.height, 0.0f);
  EXPECT_EQ(counting.asked, asked);
  measuring.begin_frame();
  EXPECT_FALSE(measuring.spent());
  EXPECT_EQ(measuring("A pot", style, 300).width, plain.measure("A pot", style, 300).width);
}

TEST(Measuring, WordsThatAreStillAskedForStayKnownWhileOthersComeAndGo) {
  const PlainMeasure plain;
  const CountingMeasure counting(plain);
  Measuring measuring(counting);
  const view::TextStyle style{.px = 20};
  measuring.begin_frame();
  measuring("stays", style, 300);
  for (int i = 0; i < 100000; ++i) {
    measuring.begin_frame();
    measuring(std::to_string(i), style, 300);
    const std::size_t asked = counting.asked;
    measuring("stays", style, 300);
    ASSERT_EQ(counting.asked, asked) << i;
  }
}

}  // namespace
}  // namespace onggi::screens::measuring_test
