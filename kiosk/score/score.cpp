#include "kiosk/score/score.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kiosk/score/remarks.h"

namespace onggi::score {

namespace {

/// Half the outline's points are lost at this RMS distance, of the vessel's size. At 1 % nearly
/// none are; an untouched lump lies at 5 % or more.
constexpr double kHalfOutline = 0.036;
/// The same for a single diameter that a potter would take with callipers.
constexpr double kHalfFeature = 0.06;
/// How much of the outline's points callipers and an even wall can take away.
constexpr double kFeatureShare = 0.2;
constexpr double kWallShare = 0.05;

/// 1 at 0, 0.5 at `half`, falling steadily; flat near 0, where nobody sees a difference. A rational
/// function, so that it has the same bits everywhere.
double worth(double distance, double half) {
  const double x = distance / half;
  return 1.0 / (1.0 + x * x * x);
}

double points_of(const Measures& m, const Profile& target) {
  const double size = size_of(m.target);
  const double outline = worth(m.outline_rms * m.target.height / size, kHalfOutline);

  double features = 0.0;
  const std::array<std::pair<double, double>, 4> diameters{{{m.made.belly, m.target.belly},
                                                            {m.made.mouth, m.target.mouth},
                                                            {m.made.foot, m.target.foot},
                                                            {m.made.neck, m.target.neck}}};
  for (const auto& [made, wanted] : diameters)
    features += worth(std::abs(made - wanted) / (2.0 * size), kHalfFeature) /
                static_cast<double>(diameters.size());

  // A wall need not be more even than the vessel's own, where that is known at all.
  double wall = 1.0;
  if (target.inner_wall == InnerWall::measured && m.target.wall_evenness > 0.0)
    wall = std::min(1.0, m.made.wall_evenness / m.target.wall_evenness);

  return 100.0 * outline * (1.0 - kFeatureShare + kFeatureShare * features) *
         (1.0 - kWallShare + kWallShare * wall);
}

int stars_of(double points) {
  int stars = 1;
  for (const double step : {40.0, 60.0, 75.0, 90.0})
    if (points >= step) ++stars;
  return stars;
}

}  // namespace

Score judge(const Profile& target, const Profile& made, bool scale_free, double true_scale) {
  Score score;
  score.measures = compare(target, made, scale_free);
  score.points = std::clamp(points_of(score.measures, target), 0.0, 100.0);
  score.stars = stars_of(score.points);
  score.alike = alike(score.measures, scale_free);
  if (score.points <= 97.0) score.try_next = try_next(score.measures, scale_free, true_scale);
  return score;
}

}  // namespace onggi::score
