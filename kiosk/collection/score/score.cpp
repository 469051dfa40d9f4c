#include "kiosk/collection/score/score.h"

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"
#include "kiosk/collection/score/parts.h"
#include "kiosk/collection/score/remarks.h"
#include "kiosk/collection/score/ripples.h"

namespace onggi::score {

namespace {

/// 1 at 0, 0.5 at `half`, falling steadily; flat near 0, where nobody sees a difference. A rational
/// function gives the same bits everywhere.
double worth(double distance, double half) {
  const double x = distance / half;
  return 1.0 / (1.0 + x * x * x);
}

/// The share of the points that remains after one measure.
double after(const settings::Rubric::Part& part, double distance) {
  return 1.0 - part.share + part.share * worth(distance, part.half);
}

/// The most points for an outline that is `worst` away at one place: falls from 100 through the
/// rubric's points at its limit.
double most_with(double worst, const settings::Rubric::Worst& rubric) {
  const double x = worst / rubric.limit;
  return 100.0 / (1.0 + (100.0 / rubric.points - 1.0) * x * std::sqrt(x));
}

double round_left(const Measures& m, const settings::Rubric& rubric) {
  return after(rubric.round, m.out_of_round / size_of(m.target));
}

/// A wall need not be more even than the vessel's own, if that is known.
double wall_left(const Measures& m, const Profile& target, const settings::Rubric& rubric) {
  if (target.inner_wall != InnerWall::measured || m.target.wall_evenness <= 0.0) return 1.0;
  return after(rubric.wall, std::max(0.0, 1.0 - m.made.wall_evenness / m.target.wall_evenness));
}

double points_of(const Measures& m, const Profile& target, bool scale_free,
                 const settings::Rubric& rubric) {
  const double size = size_of(m.target);
  const auto radius_apart = [size](double made, double wanted) {
    return std::abs(made - wanted) / (2.0 * size);
  };
  double left = 100.0;
  left *= after(rubric.outline, m.outline_rms * m.target.height / size);
  left *= after(rubric.volume, 1.0 - m.volume_overlap);
  left *= after(rubric.belly, radius_apart(m.made.belly, m.target.belly));
  left *= after(rubric.mouth, radius_apart(m.made.mouth, m.target.mouth));
  left *= after(rubric.neck, radius_apart(m.made.neck, m.target.neck));
  left *= after(rubric.foot, radius_apart(m.made.foot, m.target.foot));
  left *= after(rubric.curvature, m.turning_rms * 180.0 / portable::kPi);
  left *= after(rubric.opening, std::max(0.0, m.opening_lacking - kOpenEnough));
  left *= round_left(m, rubric);
  if (!scale_free)
    left *= after(rubric.height, std::abs(m.made.height - m.target.height) / m.target.height);
  left *= wall_left(m, target, rubric);
  return std::min(left, most_with(m.outline_worst_firm, rubric.worst));
}

}  // namespace

int stars_of(double points, const settings::Rubric& rubric) {
  int stars = 1;
  for (const double step : rubric.stars)
    if (points >= step) ++stars;
  return stars;
}

Score judge(const Profile& target, const Profile& made, bool scale_free, double true_scale,
            const settings::Rubric& rubric, bool by_line) {
  Score score;
  score.measures = compare(target, made, scale_free);
  score.points = std::clamp(points_of(score.measures, target, scale_free, rubric), 0.0, 100.0);
  score.stars = stars_of(score.points, rubric);
  score.alike = alike(score.measures, scale_free);
  const bool known = true_scale > 0.0;
  const double scale = known ? true_scale : 1.0;
  score.largest = largest_difference(score.measures, scale_free, scale);
  if (score.largest) take_back(score.alike, *score.largest);
  const double round = round_left(score.measures, rubric);
  const double wall = wall_left(score.measures, target, rubric);
  const Lost lost{1.0 - round, 1.0 - wall,
                  round * wall > 0.0 ? 1.0 - score.points / (100.0 * round * wall) : 0.0};
  if (score.stars < 5)
    score.try_next =
        try_next(score.measures, {scale_free, scale, by_line, lost, ripples(target, made)});
  if (known) return score;
  if (score.largest) score.largest = in_parts(*score.largest, score.measures, scale);
  for (Remark& remark : score.try_next) remark = in_parts(remark, score.measures, scale);
  return score;
}

}  // namespace onggi::score
