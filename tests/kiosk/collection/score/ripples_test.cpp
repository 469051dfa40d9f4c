#include "kiosk/collection/score/ripples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>

#include "engine/math/portable.h"
#include "kiosk/collection/score/remarks.h"
#include "kiosk/collection/score/score.h"
#include "tests/kiosk/collection/score/every_vessel.h"

namespace onggi::score::ripples_test {
namespace {

/// `of` with `by(share of the height)` added to both radii, metres.
Profile changed(const Profile& of, const std::function<double(double)>& by) {
  Profile p = resampled(of, 400);
  for (ProfilePoint& point : p.points) {
    const double off = by(point.height / p.height());
    point.outer = std::max(0.3 * point.outer, point.outer + off);
    point.inner = std::clamp(point.inner > 0.0 ? point.inner + off : 0.0, 0.0, 0.95 * point.outer);
  }
  return p;
}

/// Its place among what to try; none if it is not said.
int place_of(const char* key, const Score& score) {
  for (std::size_t i = 0; i < score.try_next.size(); ++i)
    if (score.try_next[i].key == key) return static_cast<int>(i);
  return -1;
}

double size(const Profile& p) { return size_of(dimensions(p)); }

TEST(Ripples, a_smooth_pot_of_wrong_shape_has_none) {
  for (const auto& v : vessels()) {
    const Profile& vessel = profile(v);
    for (const double by : {-0.06, -0.03, 0.03, 0.06})
      for (const double waves : {0.0, 0.5, 1.0, 1.5}) {
        const Profile smooth = changed(vessel, [&](double t) {
          return by * size(vessel) * portable::cos(2.0 * portable::kPi * waves * t);
        });
        EXPECT_EQ(ripples(vessel, smooth), 0.0) << v.id << " " << by << " " << waves;
        EXPECT_EQ(place_of("remark.rippled", judge(vessel, smooth)), -1) << v.id;
      }
    EXPECT_EQ(ripples(vessel, vessel), 0.0) << v.id;
    EXPECT_EQ(ripples(vessel, resampled(vessel, 300)), 0.0) << v.id;
  }
}

// Another vessel than the one that was wanted may have rings of its own: no vessel of the exhibit
// has.
TEST(Ripples, one_vessel_thrown_in_place_of_another_has_none) {
  const auto shelf = content::open_shelf("content/vessels");
  for (const auto& a : shelf.vessels)
    for (const auto& b : shelf.vessels)
      EXPECT_EQ(ripples(profile(a), profile(b)), 0.0) << a.id << ", thrown " << b.id;
}

TEST(Ripples, ring_upon_ring_is_said_first_and_as_deep_as_it_is) {
  for (const auto& v : vessels()) {
    const Profile& vessel = profile(v);
    for (const double rings : {6.0, 9.0, 12.0}) {
      const double deep = 0.025 * size(vessel);
      const Profile rippled = changed(
          vessel, [&](double t) { return deep * portable::sin(2.0 * portable::kPi * rings * t); });
      // From ring to groove, both sides: four times the amplitude, less what smoothing takes.
      EXPECT_NEAR(ripples(vessel, rippled) / (4.0 * deep), 1.0, 0.45) << v.id << " " << rings;
      EXPECT_EQ(place_of("remark.rippled", judge(vessel, rippled)), 0) << v.id << " " << rings;
    }
  }
}

TEST(Ripples, what_nobody_sees_is_not_spoken_of) {
  for (const auto& v : vessels()) {
    const Profile& vessel = profile(v);
    const Profile fine = changed(vessel, [&](double t) {
      return 0.0015 * size(vessel) * portable::sin(2.0 * portable::kPi * 10.0 * t);
    });
    EXPECT_EQ(ripples(vessel, fine), 0.0) << v.id;
  }
}

// A pot may be rippled and of another shape: the greater comes first.
TEST(Ripples, a_shape_that_is_far_out_comes_before_shallow_ripples) {
  for (const auto& v : content::open_shelf("content/vessels").vessels) {
    const Profile& vessel = profile(v);
    const Profile both = changed(vessel, [&](double t) {
      return size(vessel) * (0.09 * t + 0.005 * portable::sin(2.0 * portable::kPi * 9.0 * t));
    });
    EXPECT_NE(place_of("remark.rippled", judge(vessel, both)), 0) << v.id;
  }
}

}  // namespace
}  // namespace onggi::score::ripples_test
