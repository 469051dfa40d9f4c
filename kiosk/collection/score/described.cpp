#include "kiosk/collection/score/described.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace onggi::score {

namespace {

using settings::Mission;

// Share of the wanted volume at which half of the points are lost.
constexpr double kHalfVolume = 0.25;
constexpr double kHalfBound = 0.125;  // share of a bound at which half of the points are lost
constexpr double kNearEnough = 0.03;  // share of the wanted figure: no advice below it

/// How far `figure` is outside its bounds, as a share of the bound; below 0: too small.
double beyond(double figure, const std::optional<Mission::Described::Bounds>& bounds) {
  if (!bounds) return 0.0;
  if (figure < bounds->least) return figure / bounds->least - 1.0;
  if (figure > bounds->most) return figure / bounds->most - 1.0;
  return 0.0;
}

/// Falls like the likeness of outlines: flat near 0, one half at `half`.
double worth_of(double off, double half) {
  const double x = std::abs(off) / half;
  return 1.0 / (1.0 + x * x * x);
}

struct Off {
  double volume, height, mouth;
};
Off off(const Mission::Described& wanted, const Figures& made) {
  return {made.volume / wanted.volume - 1.0, beyond(made.height, wanted.height),
          beyond(made.mouth, wanted.mouth)};
}

std::string litres(double volume) {
  // In hundredths; the screens insert the language's decimal separator.
  return std::to_string(std::lround(volume * 1e5));
}
std::string whole_mm(double metres) { return std::to_string(std::lround(metres * 1e3)); }

Remark bounded(const std::string& key, double figure, const Mission::Described::Bounds& bounds) {
  return {key,
          {{"mm", whole_mm(figure)},
           {"least", whole_mm(bounds.least)},
           {"most", whole_mm(bounds.most)}}};
}

}  // namespace

Figures figures_of(const Profile& made, double volume) {
  if (made.points.empty()) return {volume, 0, 0};
  return {volume, made.height(), 2.0 * made.points.back().outer};
}

std::string most_off(const Mission::Described& wanted, const Figures& made) {
  const Off all = off(wanted, made);
  struct Word {
    double off;
    const char *less, *more;
  };
  const std::array<Word, 3> words{{{all.volume, "mission.more", "mission.less"},
                                   {all.mouth, "mission.wider", "mission.closer"},
                                   {all.height, "mission.taller", "mission.lower"}}};
  const Word& worst = *std::max_element(
      words.begin(), words.end(),
      [](const auto& a, const auto& b) { return std::abs(a.off) < std::abs(b.off); });
  if (std::abs(worst.off) <= kNearEnough) return "mission.close";
  return worst.off < 0 ? worst.less : worst.more;
}

std::vector<Remark> asked_of(const Mission::Described& wanted, const Figures& made) {
  std::vector<Remark> all{
      {"mission.holds", {{"litres", litres(made.volume)}, {"wanted", litres(wanted.volume)}}}};
  if (wanted.height) all.push_back(bounded("mission.height", made.height, *wanted.height));
  if (wanted.mouth) all.push_back(bounded("mission.mouth", made.mouth, *wanted.mouth));
  return all;
}

Score judge_described(const Mission::Described& wanted, const Figures& figures, const Profile& made,
                      const settings::Rubric& rubric) {
  Score score;
  const Off all = off(wanted, figures);
  score.points = 100.0 * worth_of(all.volume, kHalfVolume) * worth_of(all.height, kHalfBound) *
                 worth_of(all.mouth, kHalfBound);
  score.points = std::clamp(score.points, 0.0, 100.0);
  score.stars = stars_of(score.points, rubric);
  score.measures = compare(made, made, true);
  score.asked = asked_of(wanted, figures);
  if (const std::string worst = most_off(wanted, figures);
      score.stars < 5 && worst != "mission.close")
    score.try_next.push_back({worst, {}});
  return score;
}

}  // namespace onggi::score
