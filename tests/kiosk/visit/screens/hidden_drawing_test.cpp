#include "kiosk/visit/screens/hidden_drawing.h"

#include <gtest/gtest.h>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::hidden_drawing_test {
namespace {

struct Drawing : Visitor {
  explicit Drawing(const std::string& way_id) : Visitor(2, nullptr, true) { offer(way_id); }

  /// Ids of the glazes that hide what `tools` of the way leave on a jar.
  std::vector<std::string> hidden(const std::vector<std::string>& tools) const {
    const auto pot = *decorating::DecoratedPot::begin(jar(0.08), *way);
    for (const std::string& id : tools) {
      for (int n = 0; n < static_cast<int>(way->tools.size()); ++n)
        if (way->tools[static_cast<std::size_t>(n)].id == id) pot->choose_tool(n);
      for (const double share : {0.3, 0.6}) {
        pot->put({share * pot->outside(), 0.3});
        pot->end_work();
      }
    }
    pot->finish();
    std::vector<std::string> out;
    const auto hides = hiding(*pot, *wheel.kiln);
    for (std::size_t n = 0; n < hides.size(); ++n)
      if (hides[n]) out.push_back(glazes[n].id);
    return out;
  }
};

TEST(HiddenDrawing, DarkGlazeHidesDarkPaintAndClearGlazeDoesNot) {
  const Drawing v("porcelain");
  const auto hidden = v.hidden({"band", "figure"});
  EXPECT_EQ(hidden, std::vector<std::string>{"tenmoku"});
}

TEST(HiddenDrawing, DarkGlazeHidesGlossToo) {
  const Drawing v("attic");
  const auto hidden = v.hidden({"band", "figure"});
  EXPECT_EQ(hidden, std::vector<std::string>{"tenmoku"});
}

TEST(HiddenDrawing, WhatIsCutShowsUnderEveryGlaze) {
  const Drawing v("celadon");
  EXPECT_TRUE(v.hidden({"cut", "ring"}).empty());
}

TEST(HiddenDrawing, AnEvenCoverIsNoDrawing) {
  const Drawing v("burnished");
  EXPECT_TRUE(v.hidden({"ochre"}).empty());
}

TEST(HiddenDrawing, WhatIsWipedOutOfABrownGlazeDoesNotShowUnderAWhiteOrWithoutOne) {
  const Drawing v("onggi");
  const auto hidden = v.hidden({"glaze", "wipe"});
  for (const char* id : {"white_porcelain", "bare"})
    EXPECT_NE(std::ranges::find(hidden, id), hidden.end()) << id;
  EXPECT_EQ(std::ranges::find(hidden, "onggi"), hidden.end());
}

TEST(HiddenDrawing, TheKilnSaysItBeforeAGlazeIsChosen) {
  Drawing v("porcelain");
  v.make_result();
  v.touch("result.keep");
  const view::Rect mark = *v.visit->control("decorate.mark");
  v.down(mark.x + mark.w / 2, mark.y + mark.h / 2);
  v.frames(1);
  v.up(mark.x + mark.w / 2, mark.y + mark.h / 2);
  v.frames(2);
  v.touch("decorate.on");
  v.frames(1);
  EXPECT_NE(words_in(v.frame).find("Your drawing will hardly show under Tenmoku."),
            std::string::npos);
  v.touch("kiln.glaze.0");
  EXPECT_EQ(words_in(v.frame).find("will hardly show"), std::string::npos);
}

}  // namespace
}  // namespace onggi::screens::hidden_drawing_test
