#include "kiosk/visit/screens/measuring.h"

#include <gtest/gtest.h>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens {
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
}  // namespace onggi::screens
