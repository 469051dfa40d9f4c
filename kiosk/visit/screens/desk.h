#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>

#include "kiosk/collection/score/described.h"
#include "kiosk/visit/screens/comfort.h"
#include "kiosk/visit/screens/fault_note.h"
#include "kiosk/visit/screens/force_slider.h"
#include "kiosk/visit/screens/visit.h"

namespace onggi::screens {

/// What the screens of one visit share: the world, the newest status, what is asked of the program,
/// and all that is known of the visitor, which forget() drops.
class Desk {
 public:
  explicit Desk(const VisitWorld& w) : world(w) {}

  const VisitWorld world;
  loop::LoopStatus status;
  FaultNote fault_note;
  double now = 0;
  std::deque<Request> requests;
  std::optional<ScreenId> next;  ///< Where to go once the present call is over.
  bool turned = false;           ///< The same screen now shows another picture: cross-fade.

  NoteTaker notes;                                 ///< What may be counted of the visit.
  VisitNotes::End leaves = VisitNotes::End::back;  ///< How it ends, if it does now.

  /// Of the visitor.
  std::size_t language = 0;
  int card = -1;                          ///< Of the shelf, or own_card().
  int mission = -1;                       ///< Of the world's, if one was chosen.
  std::optional<score::Figures> figures;  ///< Of the pot that answers a description, as it stands.
  Profile made;
  score::Score score;
  ForceSlider force;
  Comfort comfort;
  std::size_t lesson_step = 0;  ///< Of the exhibit's lesson: the one that comes next, or is shown.
  int glaze = -1;               ///< Chosen of its kiln's; -1: none yet.
  enum class Kept { not_asked, asked, kept, failed } kept = Kept::not_asked;
  std::string kept_as, kept_at;  ///< By name, and for a phone.
  view::PictureId postcard = 0;

  int attract_card = -1;         ///< Of the exhibit: goes round the shelf, visitors or not.
  std::size_t attract_turn = 0;  ///< Likewise, round what is shown.

  void go(ScreenId id) { next = id; }
  void forget();

  const content::Language& words() const { return (*world.languages)[language]; }
  std::string say(const std::string& key,
                  const std::map<std::string, std::string>& places = {}) const {
    return words().say(key, places);
  }
  std::string title() const;
  /// The exhibit's, as this visitor has chosen to have it.
  settings::Exhibit::Screen screen() const { return comfort.applied(world.exhibit->screen); }
  bool still() const { return screen().reduced_motion; }
  bool mirrored() const { return screen().left_handed != words().right_to_left(); }

  int cards() const { return static_cast<int>(world.shelf->size()); }
  /// Of the shelf, or a mission's own.
  const ShelfCard* shelf_card(int index) const;
  content::Label label(int index) const;
  /// Of the visitor's vessel, or of attract's.
  const Wheel& wheel() const;

  int missions() const;
  const MissionCard& mission_card(int index) const;
  /// What the visitor has chosen to do; null: a vessel of the shelf, and that is all.
  const settings::Mission* on() const;
  /// What the pot is to measure, where there is no vessel to be met.
  const settings::Mission::Described* described() const;
  /// The pot is thrown by ear.
  bool eyes_closed() const { return does(settings::Mission::Kind::eyes_closed); }
  /// Two visitors throw it, a hand each.
  bool two_hands() const { return does(settings::Mission::Kind::two_hands); }
  /// Whose hand is which of the two visitors', as a key of the languages.
  std::string halves() const {
    const bool keys = two_hands() && on()->second == settings::Mission::Second::keys;
    return keys ? "mission.halves_keys" : "mission.halves";
  }
  /// What stands over the pot: the vessel's name, or the mission's.
  std::string heading() const;
  /// And over what it came to: "Inspired by: Moon jar".
  std::string answer() const;
  /// A remark in the visitor's language, litres with its own decimal sign.
  std::string said(const score::Remark& remark) const;

  /// The pot on the wheel, which rests, is the visitor's answer to `card`.
  void judge(const ShelfCard& card);
  /// Asks for the keepsake, once for a pot and its glaze.
  void keep_pot();
  /// Asks for a fresh lump; until it is on the wheel, pot_ready() is false.
  void start_pot(int index, bool scripted, const std::string& script = "follow");
  bool pot_ready() const { return !awaited_; }
  double pot_since() const { return pot_since_; }
  /// What goes before any hint, as a key of the languages: a fault, then news of a device. Empty:
  /// nothing.
  const std::string& note() const;
  /// Once a frame: what the wheel has come to.
  void look();

 private:
  bool does(settings::Mission::Kind kind) const { return on() != nullptr && on()->kind == kind; }

  int kept_glaze_ = -1;                   ///< As it was last asked for.
  std::optional<std::uint32_t> awaited_;  ///< Serial of the pot that is to be replaced.
  double pot_since_ = 0;
};

}  // namespace onggi::screens
