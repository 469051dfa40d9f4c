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
#include "kiosk/exhibit/composition/scenes.h"
#include "kiosk/ground/files/local_time.h"
#include "kiosk/picture/render/renderer.h"
#include "kiosk/visit/screens/visit.h"

namespace onggi::exhibit {

/// Which of `vessels` (at least one) a day is given to: one after the other, a day each, so that
/// every kiosk of an exhibit has the same, and each comes as often.
std::size_t of_the_day(const files::LocalMoment& day, std::size_t vessels);

/// One pot that answers what `mission` describes, on the wheel of `scene`. Problem: there is none.
Result<Profile> jar_for(const settings::Mission& mission, const SceneDef& scene);

/// What some missions cannot do without.
struct Able {
  bool sound = true;        ///< A sound card plays, and the exhibit is not silent.
  bool two_fingers = true;  ///< The glass tells two fingers apart.
  friend bool operator==(const Able&, const Able&) = default;
};

/// Why `mission` is not offered by a kiosk that can do so much; empty: it is.
std::string why_not(const settings::Mission& mission, const Able& able);

/// The missions that are on, as the screens know them: which vessel today's is, and one pot that
/// answers each description. Main thread; stays where it is, since screens look at it.
class Missions {
 public:
  static constexpr const char* kEvery = "*";
  /// `switched_on`: the id of one that is on whatever its file says, or kEvery of them; empty:
  /// none. `wall`: the clock on the wall. All outlive it.
  Missions(const settings::Exhibit& exhibit, const Scenes& scenes,
           std::function<std::time_t()> wall, std::string switched_on = {});

  /// Once a frame. With the whole shelf they are there; on another day today's is another, and
  /// those that need what has come or gone come and go with it, while nobody is here. Logs what
  /// cannot be played, and why; the others are on all the same.
  void look(const std::vector<screens::ShelfCard>& shelf, bool complete, bool nobody_is_here,
            const Able& able = {});
  /// Draws the next missing picture, and follows those of the shelf; false when none is missing.
  bool draw_next_picture(render::Renderer& renderer);
  /// In the order of their file.
  const std::vector<screens::MissionCard>& cards() const { return cards_; }
  /// A card of the shelf `shelf`, or a mission's own; null where there is none.
  const screens::ShelfCard* card(int index, const std::vector<screens::ShelfCard>& shelf) const;

 private:
  void read(const std::vector<screens::ShelfCard>& shelf);
  void add(const settings::Mission& mission, const std::vector<screens::ShelfCard>& shelf);
  void offer(const std::vector<screens::ShelfCard>& shelf, const Able& able);
  int todays(const settings::Mission& mission, const std::vector<screens::ShelfCard>& shelf) const;

  const settings::Exhibit& exhibit_;
  const Scenes& scenes_;
  std::function<std::time_t()> wall_;
  std::string switched_on_;
  bool read_ = false;
  int day_ = 0;                                      ///< As year, month and day in one.
  std::vector<settings::Mission> missions_;          ///< All good ones of the file.
  std::deque<content::Vessel> jars_;                 ///< Stay where they are: cards point at them.
  std::vector<screens::MissionCard> every_, cards_;  ///< That are on, and that are offered.
  Able able_;
};

}  // namespace onggi::exhibit
