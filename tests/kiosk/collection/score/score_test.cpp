#include "kiosk/collection/score/score.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

#include "engine/scene/lump.h"
#include "engine/scene/scene_def.h"
#include "kiosk/collection/content/language.h"
#include "tests/engine/profile/shapes.h"
#include "tests/support/open_shelf.h"

namespace onggi::score::score_test {
namespace {

namespace fs = std::filesystem;

struct Target {
  std::string name;
  Profile profile;
};

/// The exhibit's own shelf, and the real vessels where they are there.
const std::vector<Target>& targets() {
  static const std::vector<Target> all = [] {
    std::vector<Target> out{
        {"jar", shapes::jar()}, {"bottle", shapes::bottle()}, {"bowl", shapes::bowl()}};
    for (const char* shelf : {"content/vessels", "../shared/vessels"})
      if (fs::exists(shelf))
        for (const content::Vessel& v : content::open_shelf(shelf).vessels)
          out.push_back({v.id, v.extracted.profile});
    return out;
  }();
  return all;
}

/// Two sines along the height, RMS `by` times the height in all.
Profile unsteady(Profile p, double by, double phase) {
  double squares = 0.0;
  std::vector<double> offsets;
  const auto wave = [&](double t) {
    return std::sin(5.0 * t + phase) + 0.6 * std::sin(11.0 * t + 2.0 * phase);
  };
  for (int i = 0; i < 512; ++i) squares += wave((i + 0.5) / 512) * wave((i + 0.5) / 512);
  const double unit = by * p.height() / std::sqrt(squares / 512);
  for (ProfilePoint& point : p.points) {
    const double off = unit * wave(point.height / p.height());
    point.outer = std::max(1e-4, point.outer + off);
    point.inner = std::clamp(point.inner > 0.0 ? point.inner + off : 0.0, 0.0, 0.98 * point.outer);
  }
  return p;
}

// Points are counted on the wheel. As the kiln shrinks alike in every direction and a pot is
// compared at the vessel's height, they would be the same afterwards.
TEST(Score, the_kiln_changes_no_points) {
  for (const Target& t : targets()) {
    const Profile made = unsteady(t.profile, 0.02, 0.7);
    const Score before = judge(t.profile, made), after = judge(t.profile, scaled(made, 0.875));
    EXPECT_NEAR(before.points, after.points, 1e-6) << t.name;
    EXPECT_EQ(before.stars, after.stars) << t.name;
  }
}

TEST(Score, the_vessel_itself_has_all_points_and_nothing_left_to_try) {
  for (const Target& t : targets()) {
    const Score s = judge(t.profile, t.profile);
    EXPECT_EQ(s.points, 100.0) << t.name;
    EXPECT_EQ(s.stars, 5);
    EXPECT_TRUE(s.try_next.empty());
    ASSERT_FALSE(s.alike.empty());
    EXPECT_EQ(s.alike[0].key, "alike.outline");
    EXPECT_EQ(s.alike[0].places.at("percent"), "100");
  }
}

// Along the line a pot may fit in width and end below it. Scaled up it is too wide, and narrower is
// what the line denies.
TEST(Score, a_pot_that_fits_the_line_and_ends_below_it_is_too_low_and_not_too_wide) {
  for (const Target& t : targets())
    for (const double share : {0.8, 0.9, 1.15}) {
      Profile made = resampled(t.profile, 300);
      for (ProfilePoint& p : made.points) p.height *= share;
      const Score free = judge(t.profile, made), line = judge(t.profile, made, true, 1, {}, true);
      EXPECT_EQ(free.points, line.points) << t.name;
      if (line.stars == 5) continue;
      ASSERT_FALSE(line.try_next.empty()) << t.name;
      EXPECT_EQ(line.try_next[0].key, share < 1 ? "remark.short" : "remark.tall")
          << t.name << " " << share;
      EXPECT_NEAR(std::stoi(line.try_next[0].places.at("mm")),
                  1000 * std::abs(share - 1) * t.profile.height(), 1);
      for (const Remark& r : line.try_next)
        EXPECT_FALSE(r.key.ends_with(share < 1 ? "_wide" : "_narrow")) << t.name << r.key;
    }
}

// What is too wide at its own size and lower, too, is told as it is.
TEST(Score, a_pot_beyond_the_line_is_too_wide_however_low_it_is) {
  Profile made = shapes::jar();
  for (ProfilePoint& p : made.points) p.height *= 0.85, p.outer *= 1.3, p.inner *= 1.3;
  EXPECT_EQ(judge(shapes::jar(), made, true, 1, {}, true).try_next.at(0).key, "remark.belly_wide");
}

TEST(Score, following_the_outline_within_one_percent_scores_above_ninety) {
  for (const Target& t : targets())
    for (const double phase : {0.0, 1.3, 2.9, 4.4}) {
      const Score s = judge(t.profile, unsteady(t.profile, 0.01, phase));
      EXPECT_GT(s.points, 90.0) << t.name << " " << phase;
      EXPECT_EQ(s.stars, 5);
    }
}

TEST(Score, the_untouched_lump_scores_below_forty) {
  for (const Target& t : targets()) {
    const Profile target = scaled(t.profile, workspace_scale(t.profile));
    const ClayDef lump = lump_for(target, {});
    EXPECT_LT(judge(target, shapes::cylinder(lump.height, lump.outer_radius, lump.inner_radius,
                                             lump.floor_thickness))
                  .points,
              40.0)
        << t.name << ": the scene's own lump";
    for (const double share : {0.55, 0.58, 0.62}) {
      const double radius = share * t.profile.max_radius(), height = t.profile.height();
      const Score s =
          judge(t.profile, shapes::cylinder(height, radius, 0.4 * radius, 0.05 * height));
      EXPECT_LT(s.points, 40.0) << t.name << ": a column of " << share << " of its radius";
    }
  }
}

TEST(Score, a_bowl_is_no_answer_to_a_bottle) {
  EXPECT_LT(judge(shapes::bottle(), shapes::bowl()).points, 50.0);
  EXPECT_LT(judge(shapes::bowl(), shapes::bottle()).points, 50.0);
  EXPECT_LT(judge(shapes::jar(), shapes::bottle()).points, 50.0);
}

// What parts a hand that lets go slowly from a rough one: 0.1 mm and 0.3 mm, of a pot of 20 cm.
TEST(Score, a_pot_that_does_not_run_true_costs_points_and_is_told_so_unless_its_shape_is_off) {
  for (const Target& t : targets()) {
    const double size =
        std::sqrt(t.profile.height() * std::max(t.profile.height(), 2.0 * t.profile.max_radius()));
    double last = 100.1;
    for (const double off : {0.0, 0.0002, 0.0005, 0.001, 0.002, 0.004}) {
      Profile made = t.profile;
      made.out_of_round = off * size;
      const Score s = judge(t.profile, scaled(made, 0.7));
      EXPECT_LT(s.points, last) << t.name << ", " << off;
      last = s.points;
      EXPECT_EQ(s.stars == 5, off < 0.0008) << t.name << ", " << off;
      if (s.stars == 5) continue;
      ASSERT_EQ(s.try_next.size(), 1u);
      EXPECT_EQ(s.try_next[0].key, "remark.not_round");
    }
    EXPECT_GT(last, 89.9) << "a tenth at the most";
  }
  Profile made = shapes::bottle();
  made.out_of_round = 0.01;
  for (const Remark& r : judge(shapes::jar(), made).try_next) EXPECT_NE(r.key, "remark.not_round");
  // A rough pot of nearly the right shape.
  made = unsteady(shapes::jar(), 0.006, 0.7);
  made.out_of_round = 0.002 * made.height();
  EXPECT_EQ(judge(shapes::jar(), made).try_next.at(0).key, "remark.not_round");
}

TEST(Score, says_first_what_cost_the_most) {
  const auto first = [](double width, double off) {
    Profile made = shapes::jar();
    for (ProfilePoint& p : made.points) p.outer *= width, p.inner *= width;
    made.out_of_round = off * made.height();
    return judge(shapes::jar(), made).try_next.at(0).key;
  };
  EXPECT_EQ(first(1.04, 0.004), "remark.not_round") << "a tenth of the points";
  EXPECT_NE(first(1.04, 0.0006), "remark.not_round") << "the shape cost more";
  EXPECT_NE(first(1.1, 0.004), "remark.not_round");
}

TEST(Score, stars_go_with_points) {
  int last = 5;
  std::set<int> seen;
  for (int i = 0; i <= 200; ++i) {
    const Score s = judge(shapes::jar(), unsteady(shapes::jar(), 0.0005 * i, 0.7));
    EXPECT_GE(s.stars, 1);
    EXPECT_LE(s.stars, last);
    last = s.stars;
    seen.insert(s.stars);
  }
  EXPECT_EQ(seen.size(), 5u);
}

RC_GTEST_PROP(Score, size_is_worth_nothing_when_free_of_scale, ()) {
  const double factor = *rc::gen::inRange(50, 4000) / 1000.0;
  const auto& all = targets();
  const Target& t = all[*rc::gen::inRange<std::size_t>(0, all.size())];
  const Profile made = unsteady(t.profile, 0.02, 1.0);
  RC_ASSERT(std::abs(judge(t.profile, made).points -
                     judge(t.profile, scaled(made, factor)).points) < 1e-9);
}

RC_GTEST_PROP(Score, further_from_the_vessel_is_worth_less, ()) {
  const auto& all = targets();
  const Target& t = all[*rc::gen::inRange<std::size_t>(0, all.size())];
  const double phase = *rc::gen::inRange(0, 628) / 100.0;
  // Of the size that differences are judged against: on a wide dish a hand is worth more height.
  const double height = t.profile.height(), width = 2.0 * t.profile.max_radius();
  const double step_size = 0.004 * std::sqrt(std::max(1.0, width / height));
  double last = 101.0;
  for (int step = 0; step < 12; ++step) {
    const double points = judge(t.profile, unsteady(t.profile, step_size * step, phase)).points;
    // A diameter may come a little nearer while the outline goes further away.
    RC_ASSERT(points < last + 0.25);
    last = points;
  }
  RC_ASSERT(last < 45.0);
}

TEST(Score, remarks_name_the_part_and_the_true_millimetres) {
  const Profile target = scaled(shapes::jar(), 0.5);
  const auto with = [&](auto&& change) {
    Profile p = target;
    for (ProfilePoint& point : p.points) change(point, point.height / target.height());
    return judge(target, p, true, 2.0);
  };
  const Score wide = with([](ProfilePoint& p, double t) {
    if (t > 0.2 && t < 0.8) p.outer += 0.012;
  });
  ASSERT_FALSE(wide.try_next.empty());
  EXPECT_EQ(wide.try_next[0].key, "remark.belly_wide");
  EXPECT_EQ(wide.try_next[0].places.at("mm"), "48");  // 2 x 12 mm, on a vessel twice the size
  const Score narrow = with([](ProfilePoint& p, double t) {
    if (t > 0.9) p.outer -= 0.010;
  });
  ASSERT_FALSE(narrow.try_next.empty());
  EXPECT_EQ(narrow.try_next[0].key, "remark.mouth_narrow");
  const Score foot = with([](ProfilePoint& p, double t) {
    if (t < 0.1) p.outer += 0.010;
  });
  ASSERT_FALSE(foot.try_next.empty());
  EXPECT_EQ(foot.try_next[0].key, "remark.foot_wide");
}

TEST(Score, what_is_too_wide_is_told_where_the_pot_is_widest_and_too_narrow_where_the_vessel_is) {
  const Profile target = scaled(shapes::jar(), 0.5);
  const auto belly_told = [&](double from, double to, double by) {
    Profile p = target;
    for (ProfilePoint& point : p.points)
      if (const double t = point.height / target.height(); t > from && t < to) point.outer += by;
    for (const Remark& remark : judge(target, p, true, 2.0).try_next)
      if (remark.key.starts_with("remark.belly_") && remark.seen->made == remark.seen->wanted)
        return remark.seen->made;
    return -1.0;
  };
  EXPECT_NEAR(belly_told(0.75, 0.85, 0.040), 0.80, 0.06) << "a flange above the belly";
  const double belly = dimensions(target).belly_height / target.height();
  EXPECT_NEAR(belly_told(0.05, 0.95, -0.012), belly, 0.02);
}

TEST(Score, a_groove_where_no_part_has_a_name_is_told_by_its_height) {
  Profile made = shapes::cylinder(0.2, 0.05, 0.04, 0.01);
  const Profile target = resampled(made, 200);
  made = target;
  for (ProfilePoint& p : made.points)
    if (p.height > 0.07 && p.height < 0.11) p.outer -= 0.008;
  const Score s = judge(target, made);
  bool told = false;
  for (const Remark& r : s.try_next)
    if (r.key == "remark.narrow") {
      told = true;
      EXPECT_EQ(r.places.at("mm"), "16");
      EXPECT_NEAR(std::stoi(r.places.at("percent")), 45, 11);
    }
  EXPECT_TRUE(told);
}

TEST(Score, where_there_is_no_belly_nothing_is_said_of_a_widest_place) {
  const auto speaks_of_it = [](const Score& s) {
    std::vector<Remark> all = s.try_next;
    all.insert(all.end(), s.alike.begin(), s.alike.end());
    if (s.largest) all.push_back(*s.largest);
    return std::any_of(all.begin(), all.end(),
                       [](const Remark& r) { return r.key.find("belly") != std::string::npos; });
  };
  // A hair wider at one end, as a thrown cylinder is.
  const auto cylinder = [](double lean) {
    Profile p = resampled(shapes::cylinder(0.2, 0.05, 0.04, 0.01), 200);
    for (ProfilePoint& point : p.points) point.outer += lean * (point.height - 0.1);
    return p;
  };
  EXPECT_FALSE(speaks_of_it(judge(cylinder(0.01), cylinder(-0.01))));
  EXPECT_FALSE(speaks_of_it(judge(cylinder(0.01), shapes::jar()))) << "the vessel has none";
  const Score lump = judge(shapes::jar(), cylinder(-0.01));
  for (const Remark& r : lump.try_next) {
    EXPECT_NE(r.key, "remark.belly_low") << "the pot has none";
    EXPECT_NE(r.key, "remark.belly_high");
  }
}

TEST(Score, height_counts_only_when_size_does) {
  const Profile taller = scaled(shapes::jar(), 1.1);
  EXPECT_NEAR(judge(shapes::jar(), taller).points, 100.0, 1e-9);
  const Score s = judge(shapes::jar(), taller, false);
  EXPECT_LT(s.points, 97.0);
  bool told = false;
  for (const Remark& r : s.try_next) told = told || r.key == "remark.tall";
  EXPECT_TRUE(told);
}

TEST(Score, there_is_always_something_alike_and_every_key_is_known) {
  const std::vector<std::string> known = remark_keys();
  const std::set<std::string> keys(known.begin(), known.end());
  EXPECT_EQ(keys.size(), known.size());
  for (const Target& a : targets())
    for (const Target& b : targets()) {
      const Score s = judge(a.profile, b.profile);
      EXPECT_GE(s.alike.size(), 1u);
      EXPECT_LE(s.alike.size(), 3u);
      EXPECT_LE(s.try_next.size(), 3u);
      EXPECT_TRUE(s.points >= 0.0 && s.points <= 100.0);
      if (s.points < 90.0) {
        EXPECT_FALSE(s.try_next.empty()) << a.name << " " << b.name << " " << s.points;
      }
      for (const auto* list : {&s.alike, &s.try_next})
        for (const Remark& r : *list) {
          EXPECT_TRUE(keys.count(r.key)) << r.key;
          for (const auto& [place, value] : r.places) EXPECT_NE(value, "0") << r.key;
        }
    }
}

TEST(Score, every_language_of_the_exhibit_has_words_for_every_remark) {
  const fs::path languages = "content/languages";
  if (!fs::exists(languages)) GTEST_SKIP() << "there is no " << languages;
  for (const auto& file : fs::directory_iterator(languages)) {
    const auto language = content::Language::read(file.path());
    ASSERT_TRUE(language) << to_text(language.error());
    for (const std::string& key : remark_keys())
      EXPECT_TRUE(language->has(key)) << file.path() << " " << key;
  }
}

}  // namespace
}  // namespace onggi::score::score_test
