#include "kiosk/visit/screens/decorate_drawing.h"

#include <gtest/gtest.h>

#include "tests/kiosk/visit/screens/decorator.h"

namespace onggi::screens::decorate_drawing_test {
namespace {

TEST(DecorateDrawing, AVisitorWithKeysSeesWhereTheMarkIsOnClayOfAnyColour) {
  Decorator v;
  v.touch("result.keep");
  const auto seen = [&](view::Color color, std::size_t points) {
    return std::ranges::any_of(v.frame.items, [&](const view::Item& item) {
      const auto* line = std::get_if<view::Line>(&item);
      return line != nullptr && line->points.size() > points &&
             view::same_hue(line->colors.front(), color) && line->colors.front().a > 0.9f;
    });
  };
  EXPECT_FALSE(seen(view::kPlaster, 20));
  for (int n = 0; n < 8 && v.visit->focus() != "decorate.mark"; ++n) v.key(view::Key::right);
  ASSERT_EQ(v.visit->focus(), "decorate.mark");
  EXPECT_TRUE(seen(view::kPlaster, 20)) << "on dark clay";
  EXPECT_TRUE(seen(view::kInk, 20)) << "on white slip";
}

TEST(DecorateDrawing, AWordSaysThatTheClayHasComeFurtherAndGoesByItself) {
  Decorator v("porcelain");
  v.touch("result.keep");
  EXPECT_EQ(words_in(v.frame).find("It has been fired once."), std::string::npos);
  v.stroke(20, 20);
  EXPECT_NE(words_in(v.frame).find("It has been fired once."), std::string::npos);
  v.frames(4);
  EXPECT_EQ(words_in(v.frame).find("It has been fired once."), std::string::npos);
  v.stroke(20, -40);
  EXPECT_EQ(words_in(v.frame).find("It has been fired once."), std::string::npos);
}

TEST(DecorateDrawing, NoWordCoversTheRimOfATallPotNorAnyOfIt) {
  for (const auto& [width, height] : {std::pair{1280, 720}, {1080, 1920}, {1920, 1080}})
    for (const float tilt : {0.0f, 400.0f}) {
      Decorator v("porcelain");
      v.width = width;
      v.height = height;
      v.show();
      v.touch("result.keep");
      v.frames(1);
      if (tilt > 0) {
        using Kind = view::InputEvent::Kind;
        const auto [x, y] = v.middle();
        v.finger(0, Kind::pointer_down, x - 40, y);
        v.show();
        v.finger(1, Kind::pointer_down, x + 40, y);
        for (const int finger : {0, 1})
          v.finger(finger, Kind::pointer_move, x - 40 + 80.0f * static_cast<float>(finger),
                   y + tilt);
        v.show();
        for (const int finger : {1, 0}) v.finger(finger, Kind::pointer_up, x, y + tilt);
        v.show();
      }
      v.stroke(20, 20);
      const auto box = v.box_of("It has been fired once.");
      ASSERT_TRUE(box) << width;
      EXPECT_FALSE(v.covers_pot(*box)) << width << " " << tilt;
      EXPECT_GE(box->x, 0) << width;
      EXPECT_LE(box->y + box->h, static_cast<float>(height)) << width << " " << tilt;
      for (const auto& [id, rect] : v.visit->controls())
        EXPECT_TRUE(id == "decorate.mark" || rect.y >= box->y + box->h ||
                    rect.x >= box->x + box->w || rect.x + rect.w <= box->x ||
                    rect.y + rect.h <= box->y)
            << width << " " << id;
    }
}

TEST(DecorateDrawing, StartsOfTheVesselsMakersAreHintedUntilTheirZoneIsTouched) {
  Decorator v;
  decoration::Start start;
  start.at = 0.5, start.reach = 0.3, start.repeats = 8;
  start.from = {0.0, -0.02}, start.to = {0.0, 0.01};
  v.vessels[0].starts = {start};
  v.touch("result.keep");
  v.frames(1);
  EXPECT_GE(v.faint_strokes(), 2);
  EXPECT_LE(v.faint_strokes(), 5);
  const std::string said = "Begin at the pale marks, as its makers did.";
  ASSERT_TRUE(v.box_of(said)) << words_in(v.frame);
  EXPECT_FALSE(v.covers_pot(*v.box_of(said)));
  const auto told = v.visit->reading().words;
  EXPECT_NE(std::ranges::find(told, said), told.end());
  v.stroke(10, 30);
  EXPECT_EQ(v.faint_strokes(), 0);
  EXPECT_FALSE(v.box_of(said));
  v.touch("decorate.undo");
  v.show();
  EXPECT_GE(v.faint_strokes(), 2);
  // A finger in wet glaze could make one, but there is no glaze yet.
  Decorator early("onggi");
  early.vessels[0].starts = {start};
  early.touch("result.keep");
  for (std::size_t n = 0; n < early.way->tools.size(); ++n)
    if (early.way->tools[n].id == "wipe") early.touch("decorate.tool." + std::to_string(n));
  ASSERT_TRUE(early.pot()->waits(early.pot()->tool()));
  early.frames(1);
  EXPECT_EQ(early.faint_strokes(), 0);
  EXPECT_FALSE(early.box_of(said));
}

}  // namespace
}  // namespace onggi::screens::decorate_drawing_test
