#pragma once

#include "engine/profile/profile.h"
#include "kiosk/collection/score/score.h"
#include "kiosk/collection/settings/mission_file.h"

namespace onggi::score {

/// The figures of a pot that a description uses. Metres and m^3.
struct Figures {
  double volume = 0;  ///< Its capacity (ClayView::capacity).
  double height = 0;
  double mouth = 0;  ///< Outer diameter at the rim.
  friend bool operator==(const Figures&, const Figures&) = default;
};
/// The figures of a pot that holds `volume`; `made` may be empty.
Figures figures_of(const Profile& made, double volume);

/// The figure that is furthest from the wanted one, as a language key for the visitor at work:
/// mission.more, mission.less, mission.wider, mission.closer, mission.taller, mission.lower, or
/// mission.close if all are near.
std::string most_off(const settings::Mission::Described& wanted, const Figures& made);

/// Each figure beside the wanted one, as language keys: Score::asked.
std::vector<Remark> asked_of(const settings::Mission::Described& wanted, const Figures& made);

/// Judges a pot by figures, without a vessel: 100 points if it holds the wanted volume and keeps
/// within its bounds. Half of the points are lost if the volume is a quarter off, or if a bound is
/// missed by an eighth; the factors multiply. `Score::asked` has each figure beside the wanted one,
/// and `try_next` has the largest fault, nothing with five stars. Its `measures` compare `made`
/// with itself. The same bits on every machine. Allocates.
Score judge_described(const settings::Mission::Described& wanted, const Figures& figures,
                      const Profile& made, const settings::Rubric& rubric = {});

}  // namespace onggi::score
