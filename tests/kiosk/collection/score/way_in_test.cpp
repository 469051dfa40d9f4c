#include <gtest/gtest.h>

#include <algorithm>

#include "kiosk/collection/score/score.h"
#include "tests/kiosk/collection/score/every_vessel.h"

// The way into a pot, over every vessel that is there: a pot that nothing goes into is none.

namespace onggi::score::way_in_test {
namespace {

/// `from` that is no more open than `left` of its own way in over the top `deep` of the height.
Profile narrowed(const Profile& from, double left, double deep) {
  Profile out = resampled(from, 400);
  const double most = left * dimensions(from).opening;
  for (ProfilePoint& p : out.points)
    if (p.height > (1.0 - deep) * out.height()) p.inner = std::min(p.inner, most * p.outer);
  return out;
}

TEST(WayIn, a_mouth_that_is_shut_or_narrow_is_worth_less_the_more_it_is_so) {
  int asked = 0;
  for (const auto& v : vessels()) {
    const bool known =
        profile(v).inner_wall == InnerWall::measured && dimensions(profile(v)).opening >= 0.3;
    if (!known) continue;
    ++asked;
    for (const double deep : {0.02, 0.2}) {
      double last = 101.0;
      for (const double left : {1.0, 0.9, 0.75, 0.6, 0.45, 0.3, 0.15}) {
        const Score s = judge(profile(v), narrowed(profile(v), left, deep));
        if (left < 0.8) {
          EXPECT_LT(s.points, last - 0.5) << v.id << " " << left << " of " << deep;
        }
        last = s.points;
      }
      EXPECT_LT(judge(profile(v), narrowed(profile(v), 0.0, deep)).points, 60.0) << v.id;
    }
    // A little less than the vessel's own is a matter of the wall, not of the mouth.
    EXPECT_GT(judge(profile(v), narrowed(profile(v), 0.86, 0.02)).points, 98.0) << v.id;
  }
  EXPECT_GE(asked, 12);
}

TEST(WayIn, where_a_vessels_way_in_was_never_seen_no_pot_is_asked_for_one) {
  for (const auto& v : vessels()) {
    Profile unseen = profile(v);
    unseen.inner_wall = InnerWall::inferred;
    const Score s = judge(unseen, narrowed(profile(v), 0.0, 0.1));
    EXPECT_GT(s.points, 99.0) << v.id;
    EXPECT_FALSE(s.largest && s.largest->key.find("opening") != std::string::npos) << v.id;
  }
}

TEST(WayIn, a_shut_mouth_is_said_first_and_is_not_called_right) {
  for (const auto& v : vessels()) {
    if (dimensions(profile(v)).opening < 0.3) continue;
    const Score shut = judge(profile(v), narrowed(profile(v), 0.0, 0.03));
    ASSERT_TRUE(shut.largest) << v.id;
    EXPECT_EQ(shut.largest->key, "difference.opening_shut") << v.id;
    ASSERT_FALSE(shut.try_next.empty());
    EXPECT_EQ(shut.try_next[0].key, "remark.opening_shut") << v.id;
    const Score half = judge(profile(v), narrowed(profile(v), 0.5, 0.03));
    ASSERT_TRUE(half.largest) << v.id;
    EXPECT_EQ(half.largest->key, "difference.opening_narrow") << v.id;
    EXPECT_EQ(half.largest->places.at("percent"), "50") << v.id;
    EXPECT_EQ(half.try_next.at(0).key, "remark.opening_narrow") << v.id;
    EXPECT_FALSE(judge(resampled(profile(v), 400), narrowed(profile(v), 0.9, 0.03)).largest)
        << v.id;
    for (const Score* s : {&shut, &half})
      for (const Remark& r : s->alike) EXPECT_NE(r.key, "alike.mouth") << v.id;
  }
}

}  // namespace
}  // namespace onggi::score::way_in_test
