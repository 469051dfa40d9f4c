#include "kiosk/score/likeness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

#include "engine/math/portable.h"
#include "kiosk/content/catalogue.h"
#include "kiosk/score/score.h"
#include "tests/engine/profile/shapes.h"

// The likeness is held to the published measure as its authors define it, written down once more.

namespace onggi::score {
namespace {

namespace fs = std::filesystem;

struct Named {
  std::string id;
  Profile profile;
};

const std::vector<Named>& vessels() {
  static const std::vector<Named> all = [] {
    std::vector<Named> out{
        {"jar", shapes::jar()}, {"bottle", shapes::bottle()}, {"bowl", shapes::bowl()}};
    for (const char* shelf : {"content/vessels", "../shared/vessels"})
      if (fs::exists(shelf))
        for (const content::Vessel& v : content::open_shelf(shelf).vessels)
          out.push_back({v.id, v.extracted.profile});
    return out;
  }();
  return all;
}

/// A polygon's turning function as steps: it runs in `direction` up to the share `until`.
struct Step {
  double until, direction;
};

std::vector<Step> turning_function(const Profile& p) {
  std::vector<std::complex<double>> corners{0.0};
  // The measure is of polygons: this one is a profile's, free of a scan's ripple.
  constexpr int kCorners = 128;
  for (int i = 0; i <= kCorners; ++i) {
    const double h = p.height() * i / kCorners;
    corners.emplace_back(p.outer_at(h), h);
  }
  corners.emplace_back(0.0, p.height());
  std::vector<Step> steps;
  double way = 0.0;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    way += std::abs(corners[i] - corners[i - 1]);
    steps.push_back({way, std::arg(corners[i] - corners[i - 1])});
  }
  for (Step& step : steps) step.until /= way;
  return steps;
}

/// Arkin et al., section 3, for p = 2, without turning or shifting: the steps of both merged.
double published(const Profile& a, const Profile& b) {
  const auto fa = turning_function(a), fb = turning_function(b);
  double at = 0.0, squares = 0.0;
  for (std::size_t i = 0, k = 0; i < fa.size() && k < fb.size();) {
    const double next = std::min(fa[i].until, fb[k].until);
    squares += (next - at) * std::pow(fa[i].direction - fb[k].direction, 2);
    at = next;
    if (fa[i].until <= next) ++i;
    if (k < fb.size() && fb[k].until <= next) ++k;
  }
  return std::sqrt(squares);
}

TEST(Likeness, orders_all_pairs_as_the_published_measure_does) {
  struct Pair {
    double likeness, apart;
  };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < vessels().size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      pairs.push_back({likeness(vessels()[i].profile, vessels()[k].profile),
                       published(vessels()[i].profile, vessels()[k].profile)});
  std::size_t asked = 0, wrong = 0;
  for (const Pair& p : pairs)
    for (const Pair& q : pairs) {
      if (p.apart >= q.apart - 0.02) continue;  // one degree
      ++asked;
      wrong += p.likeness <= q.likeness ? 1 : 0;
    }
  RecordProperty("comparisons", static_cast<int>(asked));
  EXPECT_GT(asked, 5000u);
  EXPECT_EQ(wrong, 0u) << "of " << asked;
}

TEST(Likeness, is_a_metric_and_blind_to_size) {
  for (const Named& a : vessels()) {
    EXPECT_EQ(turning_apart(a.profile, a.profile), 0.0) << a.id;
    EXPECT_EQ(likeness(a.profile, a.profile), 100.0) << a.id;
    EXPECT_NEAR(turning_apart(a.profile, scaled(a.profile, 0.01)), 0.0, 1e-6) << a.id;
    for (const Named& b : vessels()) {
      const double ab = turning_apart(a.profile, b.profile);
      EXPECT_EQ(ab, turning_apart(b.profile, a.profile));
      EXPECT_LT(ab, portable::kPi);
      for (const Named& c : vessels())
        EXPECT_LE(
            ab, turning_apart(a.profile, c.profile) + turning_apart(c.profile, b.profile) + 1e-12);
    }
  }
}

TEST(Likeness, tells_apart_what_the_points_call_equally_far) {
  const auto dish = [](double wide, double lip) {
    return shapes::vessel(
        0.04, [=](double t) { return 0.04 + wide * t + lip * t * t; }, 0.004, 0.006);
  };
  // Two shallow dishes whose walls cross: the points of a visitor are level at the bottom.
  const Profile one = dish(0.12, 0.0), two = dish(0.05, 0.14);
  const Profile tall = shapes::bottle();
  EXPECT_LT(judge(one, two).points, 20.0);
  EXPECT_GT(likeness(one, two), 70.0);
  EXPECT_GT(likeness(one, two), likeness(one, tall) + 25.0);
}

TEST(Likeness, the_same_vessel_in_two_encodings_is_alike) {
  const auto find = [](const std::string& id) {
    return std::find_if(vessels().begin(), vessels().end(),
                        [&](const Named& v) { return v.id == id; });
  };
  const auto a = find("polyhaven_ceramic_vase_01_quant");
  const auto b = find("polyhaven_ceramic_vase_01_meshopt");
  if (a == vessels().end() || b == vessels().end()) GTEST_SKIP() << "the vases are not there";
  EXPECT_GT(likeness(a->profile, b->profile), 97.0);
}

}  // namespace
}  // namespace onggi::score
