#include "kiosk/collection/score/in_words.h"

#include <gtest/gtest.h>

#include "kiosk/collection/content/language.h"
#include "tests/engine/profile/shapes.h"

namespace onggi::score::in_words_test {
namespace {

Profile wider(Profile p, double by) {
  for (ProfilePoint& point : p.points) point.outer *= by, point.inner *= by;
  return p;
}

TEST(InWords, no_remark_keeps_a_figure) {
  for (const double by : {0.4, 0.7, 0.9, 1.15, 1.5})
    for (const Profile& vessel : {shapes::jar(), shapes::bottle(), shapes::bowl()})
      for (const bool scale_free : {true, false}) {
        const Score score = judge(vessel, wider(shapes::jar(), by), scale_free, 1.0);
        for (const auto* all : {&score.alike, &score.try_next})
          for (const Remark& remark : *all) {
            const Remark plain = in_words(remark);
            EXPECT_FALSE(plain.places.contains("mm")) << remark.key;
            EXPECT_FALSE(plain.places.contains("percent")) << remark.key;
          }
      }
}

TEST(InWords, what_is_far_too_narrow_is_much_wider_next_time_and_the_reverse) {
  const auto first = [](double by) {
    return in_words(judge(shapes::jar(), wider(shapes::jar(), by)).try_next.at(0)).key;
  };
  EXPECT_EQ(first(0.6), "plain.much_wider");
  EXPECT_EQ(first(0.93), "plain.wider");
  EXPECT_EQ(first(1.07), "plain.narrower");
  EXPECT_EQ(first(1.6), "plain.much_narrower");
}

TEST(InWords, the_place_is_the_parts_or_else_the_heights) {
  const auto place = [](const char* key, double height) {
    return in_words({key, {{"mm", "8"}}, Remark::Seen{height, height, 0.1}}).places.at("place");
  };
  EXPECT_EQ(place("remark.belly_wide", 0.2), "belly");
  EXPECT_EQ(place("remark_part.mouth_narrow", 1.0), "rim");
  EXPECT_EQ(place("remark.neck_wide", 0.8), "neck");
  EXPECT_EQ(place("remark.neck_wide", 0.95), "rim") << "as at the wheel: it is right below the lip";
  EXPECT_EQ(place("remark.foot_wide", 0.0), "foot");
  EXPECT_EQ(place("remark.wide", 0.05), "foot");
  EXPECT_EQ(place("remark.wide", 0.3), "low");
  EXPECT_EQ(place("remark.narrow", 0.5), "middle");
  EXPECT_EQ(place("remark.narrow", 0.7), "high");
  EXPECT_EQ(place("remark.narrow", 0.97), "rim");
}

TEST(InWords, what_has_no_figure_is_said_as_it_is) {
  EXPECT_EQ(in_words({"remark.opening_shut", {}}).key, "remark.opening_shut");
  EXPECT_EQ(in_words({"alike.mouth", {}}).key, "alike.mouth");
}

}  // namespace
}  // namespace onggi::score::in_words_test
