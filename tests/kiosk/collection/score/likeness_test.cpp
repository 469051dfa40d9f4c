#include "kiosk/collection/score/likeness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <initializer_list>
#include <numeric>

#include "engine/math/portable.h"
#include "kiosk/collection/score/score.h"
#include "tests/engine/profile/shapes.h"
#include "tests/support/open_shelf.h"

// The likeness is held to the published measure as its authors define it, written down once more.

namespace onggi::score::likeness_test {
namespace {

namespace fs = std::filesystem;

struct Named {
  std::string id;
  Profile profile;
};

/// Three drawn ones and those of `shelves`.
std::vector<Named> vessels_of(std::initializer_list<const char*> shelves) {
  std::vector<Named> out{
      {"jar", shapes::jar()}, {"bottle", shapes::bottle()}, {"bowl", shapes::bowl()}};
  for (const char* shelf : shelves)
    if (fs::exists(shelf))
      for (const content::Vessel& v : content::open_shelf(shelf).vessels)
        out.push_back({v.id, v.extracted.profile});
  return out;
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
  const std::vector<Named> vessels = vessels_of({"content/vessels", "../shared/vessels"});
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < vessels.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      pairs.push_back({likeness(vessels[i].profile, vessels[k].profile),
                       published(vessels[i].profile, vessels[k].profile)});
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
  const std::vector<Named> vessels = vessels_of({"content/vessels"});
  const std::size_t n = vessels.size();
  std::vector<std::vector<double>> apart(n, std::vector<double>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k)
      apart[i][k] = turning_apart(vessels[i].profile, vessels[k].profile);
  for (std::size_t i = 0; i < n; ++i) {
    const Profile& p = vessels[i].profile;
    EXPECT_EQ(apart[i][i], 0.0) << vessels[i].id;
    EXPECT_EQ(likeness(p, p), 100.0) << vessels[i].id;
    EXPECT_NEAR(turning_apart(p, scaled(p, 0.01)), 0.0, 1e-6) << vessels[i].id;
    for (std::size_t k = 0; k < n; ++k) {
      EXPECT_EQ(apart[i][k], apart[k][i]);
      EXPECT_LT(apart[i][k], portable::kPi);
      for (std::size_t by = 0; by < n; ++by)
        EXPECT_LE(apart[i][k], apart[i][by] + apart[by][k] + 1e-12);
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
  const std::string vase = "../shared/vessels/polyhaven_ceramic_vase_01_";
  if (!fs::exists(vase + "quant.glb")) GTEST_SKIP() << "the vases are not there";
  const auto a = content::load_vessel(vase + "quant.glb");
  const auto b = content::load_vessel(vase + "meshopt.glb");
  ASSERT_TRUE(a && b);
  EXPECT_GT(likeness(a->extracted.profile, b->extracted.profile), 97.0);
}

TEST(Likeness, names_the_neighbour_of_a_vessel_and_none_where_nothing_is_alike) {
  const Profile jar = shapes::jar(), small = scaled(jar, 0.3), bottle = shapes::bottle(),
                bowl = shapes::bowl();
  const Profile* shelf[] = {&bottle, &jar, nullptr, &small, &bowl};
  EXPECT_EQ(most_alike(jar, shelf), 3u);
  EXPECT_EQ(most_alike(small, shelf), 1u);
  ASSERT_LT(likeness(bowl, bottle), kAlikeEnough);
  const Profile* unlike[] = {&bottle, &bowl};
  EXPECT_FALSE(most_alike(bowl, unlike));
  EXPECT_FALSE(most_alike(jar, {}));
  // Of two that are the same the first, and never a vessel itself.
  const Profile again = small;
  const Profile* twice[] = {&jar, &again, &small};
  EXPECT_EQ(most_alike(jar, twice), 1u);
}

}  // namespace
}  // namespace onggi::score::likeness_test
