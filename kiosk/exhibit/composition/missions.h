#pragma once

#include <ctime>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/profile/profile.h"
#include "engine/scene/scene_def.h"
#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/exhibit/composition/card_picture.h"
#include "kiosk/exhibit/composition/scenes.h"
#include "kiosk/ground/files/local_time.h"
#include "kiosk/picture/render/renderer.h"
#include "kiosk/visit/screens/visit.h"

namespace onggi::exhibit {

/// Which of `vessels` (at least one) is today's: one a day in turn, so that every kiosk of an
/// exhibit shows the same, and each comes equally often.
std::size_t of_the_day(const files::LocalMoment& day, std::size_t vessels);

/// A pot that answers `mission`'s description, on the wheel of `scene`. Problem: there is none.
Result<Profile> jar_for(const settings::Mission& mission, const SceneDef& scene);

/// Capabilities that some missions need.
struct Capabilities {
  bool sound = true;        ///< A sound card works, and the exhibit is not silent.
  bool two_fingers = true;  ///< The screen can follow two fingers.
  friend bool operator==(const Capabilities&, const Capabilities&) = default;
};

/// Why a kiosk with these capabilities does not offer `mission`; empty: it does.
std::string reason_unavailable(const settings::Mission& mission, const Capabilities& able);

/// The missions that are on, for the screens, with today's vessel, and a pot that answers each
/// description. Main thread; not movable, because screens point at it.
class Missions {
 public:
  static constexpr const char* kEvery = "*";
  /// `switched_on`: id of a mission that is on whatever its file says, or kEvery; empty: none.
  /// `wall`: the wall clock. All arguments outlive it.
  Missions(const settings::Exhibit& exhibit, const Scenes& scenes,
           std::function<std::time_t()> wall, std::string switched_on = {});

  /// Call once a frame. The missions are ready when the shelf is complete. While nobody is here, a
  /// new day changes today's vessel, and missions come and go with the capabilities that they need.
  /// Logs missions that cannot be played, and why; the others are still on.
  void look(const std::vector<screens::ShelfCard>& shelf, bool complete, bool nobody_is_here,
            const Capabilities& able = {});
  /// Draws the next missing picture, and copies those of the shelf; false when none is missing.
  bool draw_next_picture(render::Renderer& renderer);
  /// In the order of their file.
  const std::vector<screens::MissionCard>& cards() const { return cards_; }
  /// A card of the shelf `shelf`, or a mission's own; null if there is none.
  const screens::ShelfCard* card(int index, const std::vector<screens::ShelfCard>& shelf) const;

 private:
  void read(const std::vector<screens::ShelfCard>& shelf);
  void add(const settings::Mission& mission, const std::vector<screens::ShelfCard>& shelf);
  void offer(const std::vector<screens::ShelfCard>& shelf, const Capabilities& able);
  int todays(const settings::Mission& mission, const std::vector<screens::ShelfCard>& shelf) const;

  const settings::Exhibit& exhibit_;
  const Scenes& scenes_;
  std::function<std::time_t()> wall_;
  std::string switched_on_;
  bool read_ = false;
  int day_ = 0;                              ///< Year, month and day in one number.
  std::vector<settings::Mission> missions_;  ///< All valid ones of the file.
  std::deque<content::Vessel> jars_;         ///< Not movable: cards point at them.
  /// Those that are on, and those that are offered.
  std::vector<screens::MissionCard> every_, cards_;
  CardPicture picture_;
  Capabilities able_;
};

}  // namespace onggi::exhibit
