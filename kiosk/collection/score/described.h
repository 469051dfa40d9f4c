#pragma once

#include "engine/profile/profile.h"
#include "kiosk/collection/score/score.h"
#include "kiosk/collection/settings/mission_file.h"

namespace onggi::score {

/// What of a pot a description speaks of. Metres and m^3.
struct Figures {
  double volume = 0;  ///< That it holds (ClayView::capacity).
  double height = 0;
  double mouth = 0;  ///< Outer diameter at the rim.
  friend bool operator==(const Figures&, const Figures&) = default;
};
/// Of a pot that holds `volume`; `made` may be empty.
Figures figures_of(const Profile& made, double volume);

/// Of what is asked: the figure that is furthest from it, for who works on it. As a key of the
/// languages: mission.more, mission.less, mission.wider, mission.closer, mission.taller,
/// mission.lower, or mission.close where each is near.
std::string most_off(const settings::Mission::Described& wanted, const Figures& made);

/// Each figure beside what was asked, as keys of the languages: Score::asked.
std::vector<Remark> asked_of(const settings::Mission::Described& wanted, const Figures& made);

/// A pot against figures, without any vessel: 100 points where it holds what was asked and keeps
/// within its bounds, half of them where its volume is a quarter off, or a bound missed by an
/// eighth, and each multiplies the others. `Score::asked` has each figure beside what was asked,
/// `try_next` what lacks most, nothing above 97 points. Its `measures` are of `made` alone, against
/// itself. The same bits on every machine. Allocates.
Score judge_described(const settings::Mission::Described& wanted, const Figures& figures,
                      const Profile& made, const settings::Rubric& rubric = {});

}  // namespace onggi::score
