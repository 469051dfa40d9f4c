#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "kiosk/collection/score/score.h"
#include "tests/engine/profile/poses.h"
#include "tests/kiosk/collection/score/every_vessel.h"

// What a score must keep, over every vessel that is there: the exhibit's own and, where they are
// beside this clone, scans that nobody here made.

namespace onggi::score::properties_test {
namespace {

TEST(ScoreProperties, measures_are_the_same_both_ways_where_neither_has_a_size) {
  for (const auto& a : vessels())
    for (const auto& b : vessels()) {
      const Measures ab = compare(profile(a), profile(b), true);
      const Measures ba = compare(profile(b), profile(a), true);
      EXPECT_NEAR(ab.outline_overlap, ba.outline_overlap, 1e-9) << a.id << " " << b.id;
      EXPECT_NEAR(ab.volume_overlap, ba.volume_overlap, 1e-9) << a.id << " " << b.id;
      EXPECT_NEAR(ab.outline_rms, ba.outline_rms, 1e-9) << a.id << " " << b.id;
      EXPECT_NEAR(ab.outline_worst, ba.outline_worst, 1e-9) << a.id << " " << b.id;
      EXPECT_NEAR(ab.outline_worst_firm, ba.outline_worst_firm, 1e-9) << a.id << " " << b.id;
      EXPECT_NEAR(ab.turning_rms, ba.turning_rms, 1e-9) << a.id << " " << b.id;
    }
}

TEST(ScoreProperties, turning_moving_and_scaling_the_scan_changes_nothing) {
  unsigned seed = 0;
  for (const auto& v : vessels()) {
    const double scale = 0.01 * (1.0 + 37.0 * (++seed % 5));
    const TriangleMesh elsewhere = shapes::moved(v.mesh, shapes::random_pose(seed), scale);
    const auto found = extract_profile(elsewhere, {}, v.id);
    ASSERT_TRUE(found) << to_text(found.error());
    // A vessel without an opening may be taken to stand on its head; that is said.
    if (v.extracted.up_from != UpFrom::opening) continue;
    EXPECT_GT(judge(profile(v), found->profile).points, 98.5) << v.id;
    for (const auto& other : {&vessels().front(), &vessels().back()}) {
      EXPECT_NEAR(judge(profile(*other), found->profile).points,
                  judge(profile(*other), profile(v)).points, 1.5)
          << v.id << " as an answer to " << other->id;
    }
  }
}

TEST(ScoreProperties, who_is_out_by_more_than_five_percent_of_the_height_anywhere_stays_below_90) {
  for (const auto& a : vessels())
    for (const auto& b : vessels()) {
      const Profile &p = profile(a), q = scaled(profile(b), p.height() / profile(b).height());
      double worst = 0.0;
      for (int i = 0; i <= 400; ++i) {
        const double h = p.height() * i / 400;
        worst = std::max(worst, std::abs(p.outer_at(h) - q.outer_at(h)));
      }
      if (worst > 0.05 * p.height()) {
        EXPECT_LT(judge(p, profile(b)).points, 90.0) << a.id << " " << b.id;
      }
    }
}

TEST(ScoreProperties, one_narrow_ridge_is_enough_to_stay_below_90) {
  for (const auto& v : vessels())
    for (const double at : {0.03, 0.2, 0.5, 0.8, 0.97}) {
      Profile ridged = resampled(profile(v), 600);
      const double height = ridged.height();
      // On a wall that runs out twice as fast as up, 5 % is a matter of a hair up or down.
      const double steepest = [&] {
        double slope = 0.0;
        for (double t = at - 0.02; t < at + 0.02; t += 0.002)
          slope = std::max(
              slope, std::abs(ridged.outer_at((t + 0.004) * height) - ridged.outer_at(t * height)) /
                         (0.004 * height));
        return slope;
      }();
      if (steepest > 2.0) continue;
      for (ProfilePoint& p : ridged.points)
        if (std::abs(p.height / height - at) < 0.01) p.outer += 0.052 * height;
      EXPECT_LT(judge(profile(v), ridged).points, 90.0) << v.id << " at " << at;
    }
}

TEST(ScoreProperties, vessels_that_share_less_than_two_thirds_of_their_volume_are_unlike) {
  for (const auto& a : vessels())
    for (const auto& b : vessels()) {
      const Score s = judge(profile(a), profile(b));
      if (s.measures.volume_overlap < 2.0 / 3.0) {
        EXPECT_LT(s.points, 50.0) << a.id << " " << b.id;
      }
    }
}

TEST(ScoreProperties, the_same_vessel_in_two_encodings_scores_above_99) {
  const auto find = [](const std::string& id) -> const content::Vessel* {
    for (const auto& v : vessels())
      if (v.id == id) return &v;
    return nullptr;
  };
  const auto* quantised = find("polyhaven_ceramic_vase_01_quant");
  const auto* compressed = find("polyhaven_ceramic_vase_01_meshopt");
  if (quantised != nullptr && compressed != nullptr) {
    EXPECT_GT(judge(profile(*quantised), profile(*compressed)).points, 99.0);
  }
  for (const auto& v : vessels()) {
    // Corners rounded to 12 bits of the vessel's size, as exporters do: on a plate half a percent
    // of its height, and no longer the same plate.
    if (profile(v).height() < 0.8 * profile(v).max_radius()) continue;
    TriangleMesh coarse = v.mesh;
    float size = 0.0f;
    for (const auto& p : coarse.positions)
      for (const float x : p) size = std::max(size, std::abs(x));
    for (auto& p : coarse.positions)
      for (float& x : p) x = std::round(x / size * 2047.0f) * size / 2047.0f;
    ExtractionOptions options;
    options.up = Vec3{0, 1, 0};
    const auto found = extract_profile(coarse, options, v.id);
    ASSERT_TRUE(found) << to_text(found.error());
    EXPECT_GT(judge(profile(v), found->profile).points, 99.0) << v.id;
  }
}

/// A way to spoil a vessel, by `amount` of its height.
struct Distortion {
  const char* name;
  std::function<void(ProfilePoint&, double t, double amount, const Profile&)> change;
};

double bump(double t, double at, double wide) {
  const double x = (t - at) / wide;
  return std::abs(x) >= 1.0 ? 0.0 : (1.0 - x * x) * (1.0 - x * x);
}

const std::vector<Distortion>& distortions() {
  static const std::vector<Distortion> all{
      {"fatter", [](ProfilePoint& p, double, double by, const Profile&) { p.outer += by; }},
      {"thinner", [](ProfilePoint& p, double, double by,
                     const Profile&) { p.outer = std::max(0.3 * p.outer, p.outer - by); }},
      {"swollen in the middle", [](ProfilePoint& p, double t, double by,
                                   const Profile&) { p.outer += 1.5 * by * bump(t, 0.5, 0.35); }},
      {"flaring upwards",
       [](ProfilePoint& p, double t, double by, const Profile&) { p.outer += 2.0 * by * t; }},
      {"spread at the foot", [](ProfilePoint& p, double t, double by,
                                const Profile&) { p.outer += 2.0 * by * bump(t, 0.0, 0.3); }},
      {"opened at the mouth", [](ProfilePoint& p, double t, double by,
                                 const Profile&) { p.outer += 2.0 * by * bump(t, 1.0, 0.3); }},
      {"rippled",
       [](ProfilePoint& p, double t, double by, const Profile&) {
         p.outer = std::max(0.3 * p.outer, p.outer + by * portable::sin(25.0 * t));
       }},
  };
  return all;
}

TEST(ScoreProperties, further_from_the_vessel_in_any_way_is_worth_less) {
  for (const auto& v : vessels())
    for (const Distortion& d : distortions()) {
      const Profile from = resampled(profile(v), 300);
      double last = 100.0 + 1e-9, first = 0.0;
      for (int step = 0; step <= 16; ++step) {
        Profile spoilt = from;
        for (ProfilePoint& p : spoilt.points) {
          const double wall = p.outer - p.inner;
          d.change(p, p.height / from.height(), 0.006 * step * from.height(), from);
          p.inner = p.inner > 0.0 ? std::max(0.05 * p.outer, p.outer - wall) : 0.0;
        }
        const double points = judge(profile(v), spoilt).points;
        // A neck that widens on the way to a bottle's mouth may come right once before all is
        // wrong.
        EXPECT_LT(points, last + 0.3) << v.id << ", " << d.name << ", step " << step;
        if (step == 0) first = points;
        last = points;
      }
      EXPECT_GT(first, 99.0) << v.id;
      // On a dish a tenth of the height is little of its size.
      const double wide = 2.0 * profile(v).max_radius() / profile(v).height();
      EXPECT_LT(last, wide < 1.5 ? 60.0 : 89.0) << v.id << ", " << d.name;
    }
}

TEST(ScoreProperties, an_uneven_wall_is_worth_less_the_more_uneven_it_is) {
  for (const auto& v : vessels()) {
    if (profile(v).inner_wall != InnerWall::measured) continue;
    double last = 101.0;
    for (const double by : {0.0, 0.2, 0.4, 0.6, 0.8}) {
      Profile spoilt = resampled(profile(v), 300);
      for (ProfilePoint& p : spoilt.points)
        if (p.inner > 0.0) {
          const double t = p.height / spoilt.height(), wall = p.outer - p.inner;
          p.inner = std::clamp(p.outer - wall * (1.0 + by * portable::sin(20.0 * t)),
                               0.02 * p.outer, 0.98 * p.outer);
        }
      const Score s = judge(profile(v), spoilt);
      // A scan's own wall may be so uneven that more of it is not less even.
      EXPECT_LE(s.points, last + 0.3) << v.id << " " << by;
      last = s.points;
    }
  }
}

TEST(ScoreProperties, the_words_name_the_place_and_the_millimetres) {
  const Profile bottle = resampled(
      shapes::vessel(
          0.33,
          [](double t) {
            return 0.030 + 0.05 * std::exp(-14.0 * (t - 0.35) * (t - 0.35)) + 0.012 * t * t * t * t;
          },
          0.004, 0.010),
      400);
  const Dimensions d = dimensions(bottle);
  ASSERT_GT(d.neck_height, 0.6 * d.height);
  ASSERT_LT(d.neck_height, 0.9 * d.height);
  // The part is named, and by what callipers find of it: a bump may move the narrowest place.
  Dimensions made;
  const auto said = [&](double at, double wide, double by) {
    Profile spoilt = bottle;
    for (ProfilePoint& p : spoilt.points) {
      const double change = by * bump(p.height / d.height, at, wide);
      p.outer += change;
      if (p.inner > 0.0) p.inner += change;
    }
    const Score s = judge(bottle, spoilt);
    made = s.measures.made;
    return s.largest ? s.largest->key + " " + s.largest->places.at("mm") : std::string("nothing");
  };
  // Where the narrowest place is widened, the neck is narrowest beside it, and widened by half.
  EXPECT_EQ(said(d.neck_height / d.height, 0.12, 0.004), "difference.wide 8");
  EXPECT_LT(made.neck - d.neck, 0.0048);
  EXPECT_EQ(said(d.neck_height / d.height, 0.12, -0.004), "difference.neck_narrow 8");
  EXPECT_NEAR(made.neck - d.neck, -0.008, 0.0005);
  EXPECT_EQ(said(d.belly_height / d.height, 0.12, 0.006), "difference.belly_wide 12");
  EXPECT_NEAR(made.belly - d.belly, 0.012, 0.0005);
  EXPECT_EQ(said(0.0, 0.15, 0.005), "difference.foot_wide 10");
  EXPECT_NEAR(made.foot - d.foot, 0.010, 0.0005);
  EXPECT_EQ(said(1.0, 0.10, -0.005), "difference.mouth_narrow 10");
  EXPECT_NEAR(made.mouth - d.mouth, -0.010, 0.0005);
  EXPECT_EQ(said(0.58, 0.06, 0.006), "difference.wide 12");
  EXPECT_EQ(said(0.5, 0.1, 0.0), "nothing");
  const Score taller = judge(bottle, scaled(bottle, 1.1), false);
  ASSERT_TRUE(taller.largest);
  EXPECT_EQ(taller.largest->key, "difference.tall");
  EXPECT_EQ(taller.largest->places.at("mm"), "33");
}

/// What callipers find of `part`, in metres.
double figure(const std::string& part, const Dimensions& d) {
  return part == "belly" ? d.belly : part == "neck" ? d.neck : part == "mouth" ? d.mouth : d.foot;
}

/// Does `remark` say what the figures beside it say?
void expect_true(const Remark& remark, const Profile& wanted, const Profile& made,
                 const Measures& m, const std::string& pair) {
  SCOPED_TRACE(pair + ": " + remark.key);
  const std::string ending = remark.key.substr(remark.key.find('.') + 1);
  if (ending == "wall_uneven" || ending == "rippled") return;
  if (ending == "opening_shut" || ending == "opening_narrow") {
    const double lacking = 100.0 * (1.0 - m.made.opening / m.target.opening);
    if (ending == "opening_shut") {
      EXPECT_GT(lacking, 75.0);
    } else {
      EXPECT_EQ(remark.places.at("percent"), std::to_string(std::lround(lacking)));
    }
    return;
  }
  const long mm = std::stol(remark.places.at("mm"));
  EXPECT_GT(mm, 0);
  const auto shown = [](double metres) { return std::lround(1000.0 * std::abs(metres)); };
  const bool more = ending.ends_with("wide") || ending.ends_with("high") || ending == "tall";
  if (ending == "tall" || ending == "short") {
    EXPECT_EQ(more, m.made.height > m.target.height);
    EXPECT_EQ(mm, shown(m.made.height - m.target.height));
  } else if (ending.ends_with("high") || ending.ends_with("low")) {
    EXPECT_EQ(more, m.made.belly_height > m.target.belly_height);
    EXPECT_EQ(mm, shown(m.made.belly_height - m.target.belly_height));
  } else if (ending == "wide" || ending == "narrow") {
    const double percent = std::stod(remark.places.at("percent"));
    EXPECT_GE(percent, 1.0);
    EXPECT_LE(percent, 99.0);
    // There, within what a percent is rounded by, the wall is out to that side by that much.
    double most = 0.0;
    for (double t = percent - 1.2; t <= percent + 1.2; t += 0.05) {
      const double h = std::clamp(0.01 * t, 0.0, 1.0) * wanted.height();
      const double out = m.scale * made.outer_at(h / m.scale) - wanted.outer_at(h);
      most = std::max(most, more ? out : -out);
    }
    EXPECT_GE(2000.0 * most, static_cast<double>(mm) - 0.6);
  } else {
    const std::string part = ending.substr(0, ending.find('_'));
    const double out = figure(part, m.made) - figure(part, m.target);
    EXPECT_EQ(more, out > 0.0);
    EXPECT_EQ(mm, shown(out));
  }
}

TEST(ScoreProperties, no_remark_contradicts_the_figures_beside_it) {
  for (const bool scale_free : {true, false})
    for (const auto& a : vessels())
      for (const auto& b : vessels()) {
        const Score s = judge(profile(a), profile(b), scale_free);
        const std::string pair = b.id + " for " + a.id;
        if (s.largest) expect_true(*s.largest, profile(a), profile(b), s.measures, pair);
        for (const Remark& r : s.try_next) expect_true(r, profile(a), profile(b), s.measures, pair);
        for (const Remark& r : s.alike) {
          const std::string part = r.key.substr(6);
          const bool called_wrong =
              s.largest && s.largest->key.starts_with("difference." + part + "_");
          EXPECT_FALSE(called_wrong && s.alike.size() > 1) << pair << " " << r.key;
          for (const Remark& t : s.try_next) EXPECT_NE(t.key, "remark." + part + "_wide") << pair;
        }
      }
}

TEST(ScoreProperties, a_lip_that_is_rounded_otherwise_makes_no_mouth_too_narrow) {
  for (const auto& v : vessels()) {
    Profile lipped = resampled(profile(v), 600);
    const double height = lipped.height();
    // The last half percent of the height draws in by a twentieth, as a turned lip does.
    for (ProfilePoint& p : lipped.points) {
      const double t = p.height / height;
      if (t > 0.995) p.outer -= 0.05 * height * (t - 0.995) / 0.005 * 0.9;
      p.inner = std::min(p.inner, 0.9 * p.outer);
    }
    if (lipped.points.back().outer <= 0.02 * height) continue;
    const Score s = judge(resampled(profile(v), 600), lipped);
    const Dimensions &made = s.measures.made, &wanted = s.measures.target;
    if (std::abs(made.mouth - wanted.mouth) > 0.0005) continue;
    EXPECT_TRUE(!s.largest || s.largest->key.find("mouth") == std::string::npos)
        << v.id << ": " << s.points << " " << s.largest->key << " " << s.largest->places.at("mm");
  }
}

}  // namespace
}  // namespace onggi::score::properties_test
