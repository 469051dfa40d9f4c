#include "kiosk/collection/score/parts.h"

#include <gtest/gtest.h>

#include "kiosk/collection/content/language.h"
#include "tests/engine/profile/shapes.h"

namespace onggi::score::parts_test {
namespace {

Profile wider(Profile p, double by) {
  for (ProfilePoint& point : p.points) point.outer *= by, point.inner *= by;
  return p;
}

TEST(Parts, without_a_known_size_no_remark_has_a_millimetre) {
  for (const double by : {0.4, 0.7, 0.9, 1.15, 1.5}) {
    for (const bool scale_free : {true, false}) {
      const Score known = judge(shapes::jar(), wider(shapes::jar(), by), scale_free, 1.0);
      const Score not_known = judge(shapes::jar(), wider(shapes::jar(), by), scale_free, 0.0);
      EXPECT_EQ(known.points, not_known.points);
      ASSERT_EQ(known.try_next.size(), not_known.try_next.size());
      for (std::size_t i = 0; i < known.try_next.size(); ++i) {
        const Remark& part = not_known.try_next[i];
        EXPECT_EQ(part.places.count("mm"), 0u) << part.key;
        if (known.try_next[i].places.count("mm") == 0) continue;
        EXPECT_EQ(part.places.count("part"), 1u) << part.key;
        EXPECT_EQ(part.key.rfind("remark_part.", 0), 0u) << part.key;
      }
      ASSERT_TRUE(not_known.largest);
      EXPECT_EQ(not_known.largest->key.rfind("difference_part.", 0), 0u);
    }
  }
}

TEST(Parts, a_fifth_too_narrow_is_said_so) {
  const Score score = judge(shapes::jar(), wider(shapes::jar(), 0.8), true, 0.0);
  const auto english = content::Language::read("content/languages/en.toml");
  ASSERT_TRUE(english) << to_text(english.error());
  const std::string words = english->say(score.largest->key, score.largest->places);
  EXPECT_NE(words.find("a fifth too narrow"), std::string::npos) << words;
  EXPECT_EQ(words.find('{'), std::string::npos) << words;
}

TEST(Parts, what_is_twice_as_wide_or_more_is_far_too_wide) {
  const Score score = judge(shapes::jar(), wider(shapes::jar(), 2.3), true, 0.0);
  const auto english = content::Language::read("content/languages/en.toml");
  ASSERT_TRUE(english) << to_text(english.error());
  const std::string words = english->say("difference_part.belly_wide", {{"part", "100"}});
  EXPECT_EQ(words, "The belly is far too wide.");
  ASSERT_TRUE(score.largest);
  EXPECT_EQ(english->say(score.largest->key, score.largest->places).find("as much"),
            std::string::npos);
}

TEST(Parts, a_place_too_high_or_low_is_told_as_a_part_of_the_height_and_never_as_far) {
  Measures m;
  m.target.belly = 0.2;
  m.target.height = 0.4;
  const auto part = [&m](const char* key, const char* mm) {
    return in_parts({key, {{"mm", mm}}}, m, 1.0).places.at("part");
  };
  for (const char* key : {"remark.belly_high", "remark.belly_low", "difference.belly_high"})
    for (const char* mm : {"390", "900"}) EXPECT_EQ(part(key, mm), "90") << key;
  EXPECT_EQ(part("remark.belly_wide", "900"), "100");
  EXPECT_EQ(part("difference.tall", "900"), "100");
}

TEST(Parts, a_part_is_of_the_length_it_is_about) {
  Measures m;
  m.target.belly = 0.2;
  m.target.mouth = 0.1;
  m.target.height = 0.4;
  const auto part = [&m](const char* key) {
    return in_parts({key, {{"mm", "20"}}}, m, 1.0).places.at("part");
  };
  EXPECT_EQ(part("remark.belly_wide"), "10");
  EXPECT_EQ(part("remark.mouth_narrow"), "20");
  EXPECT_EQ(part("remark.belly_high"), "5");
  EXPECT_EQ(part("difference.short"), "5");
  EXPECT_EQ(part("difference.narrow"), "10");
  EXPECT_EQ(in_parts({"alike.wall", {}}, m, 1.0).key, "alike.wall");
}

}  // namespace
}  // namespace onggi::score::parts_test
