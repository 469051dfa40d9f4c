#pragma once

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "kiosk/collection/score/described.h"
#include "kiosk/visit/screens/comfort.h"
#include "kiosk/visit/screens/fault_note.h"
#include "kiosk/visit/screens/force_slider.h"
#include "kiosk/visit/screens/visit.h"

namespace onggi::screens {

/// A label to open on the shelf.
struct LabelAt {
  int card = -1, mission = -1;  ///< As Desk's.
};
class PotPicture;

/// Shared state of a visit's screens: the world, the newest status, requests to the program, and
/// everything about the visitor. forget() clears the visitor's part.
class Desk {
 public:
  explicit Desk(const VisitInputs& w) : world(w) {}

  const VisitInputs world;
  loop::LoopStatus status;
  FaultNote fault_note;
  double now = 0;
  std::deque<Request> requests;
  std::optional<ScreenId> next;  ///< The screen to go to after the current call.
  bool by_keys = false;          ///< The last input was a key.
  bool turned = false;           ///< Same screen, other picture: cross-fade.

  NoteTaker notes;                                 ///< Takes the countable notes of the visit.
  VisitNotes::End leaves = VisitNotes::End::back;  ///< How the visit ends, if it ends now.

  bool curated = false;         ///< A curator decorates a vessel: there is no other screen.
  bool curated_to_end = false;  ///< They have left it.

  /// About the visitor.
  std::size_t language = 0;
  int card = -1;                          ///< An index on the shelf, or own_card().
  bool built = false;                     ///< The vessel is built of coils (ShelfCard::built).
  int mission = -1;                       ///< Index in the world's missions, if one was chosen.
  std::optional<LabelAt> offered;         ///< The shelf opens with this label.
  std::optional<score::Figures> figures;  ///< Current figures of a pot that answers a description.
  bool touched = false;  ///< A hand of the visitor has been at the pot that is on the wheel.
  Profile made;
  score::Score score;
  bool exactly = false;  ///< The visitor asked for figures at the result.
  ForceSlider force;
  Comfort comfort;
  /// The current or next step of the exhibit's lesson: of throwing, of building.
  std::array<std::size_t, 2> lesson_steps{};
  int glaze = -1;  ///< Index in the kiln's glazes; -1: not chosen yet.
  /// Null until the visitor comes to decorate the pot. A keepsake in the making has it, too.
  std::shared_ptr<decorating::DecoratedPot> decorated;
  enum class Kept { not_asked, asked, kept, failed } kept = Kept::not_asked;
  /// The keepsake's name, its address for a phone, and its folder.
  std::string kept_as, kept_at, kept_in;
  view::PictureId postcard = 0;

  /// Attract's picture of its pot, and the finger or arrow on its clay that began the visit: the
  /// clay screen goes on with both.
  std::shared_ptr<PotPicture> attract_picture;
  struct Began {
    view::InputEvent event;
    view::Camera camera;
  };
  std::optional<Began> began_on_clay;
  int attract_card = -1;  ///< Attract's vessel; advances along the shelf, with or without visitors.
  bool attract_builds = false;   ///< It is built of coils.
  std::size_t attract_turn = 0;  ///< Attract's script; advances through the scripts.

  void go(ScreenId id) { next = id; }
  void forget();

  const content::Language& words() const { return (*world.languages)[language]; }
  std::string say(const std::string& key,
                  const std::map<std::string, std::string>& places = {}) const {
    return words().say(key, places);
  }
  std::string title() const;
  settings::Exhibit::Screen screen() const { return comfort.applied(world.exhibit->screen); }
  bool still() const { return screen().reduced_motion; }
  bool mirrored() const { return screen().left_handed != words().right_to_left(); }

  int cards() const { return static_cast<int>(world.shelf->size()); }
  /// A card of the shelf, or a mission's own.
  const ShelfCard* shelf_card(int index) const;
  content::Label label(int index) const;
  /// The scene of the visitor's vessel, or of attract's.
  const SceneForVisitor& wheel() const;
  /// The lesson for the pot on the wheel; null if there is none.
  const std::vector<content::LessonStep>* lesson() const {
    return wheel().coil ? world.build_lesson : world.lesson;
  }
  std::size_t& lesson_step() { return lesson_steps[wheel().coil ? 1 : 0]; }
  std::size_t lesson_step() const { return lesson_steps[wheel().coil ? 1 : 0]; }

  int missions() const;
  const MissionCard& mission_card(int index) const;
  /// The visitor's mission; null if only a vessel was chosen.
  const settings::Mission* on() const;
  /// The wanted figures if the mission has no vessel to copy; else null.
  const settings::Mission::Described* described() const;
  /// True if the pot is thrown with the screen hidden.
  bool eyes_closed() const { return does(settings::Mission::Kind::eyes_closed); }
  /// True if two visitors throw it, a hand each.
  bool two_hands() const { return does(settings::Mission::Kind::two_hands); }
  /// Language key that tells which hand belongs to which of the two visitors.
  std::string halves() const {
    const bool keys = two_hands() && on()->second == settings::Mission::Second::keys;
    return keys ? "mission.halves_keys" : "mission.halves";
  }
  /// The title over the pot: the vessel's or the mission's name.
  std::string heading() const;
  /// The title over the result: "Inspired by: Moon jar".
  std::string answer() const;
  /// A remark in the visitor's language, with litres in its decimal notation.
  std::string said(const score::Remark& remark) const;

  /// The score of `pot` as an answer to `card`'s vessel.
  score::Score judged(const ShelfCard& card, const Profile& pot) const;
  /// Stores the pot on the wheel, which is paused, as the visitor's answer to `card`.
  /// `lacks_rings`: it is built of coils, and has not all of them.
  void judge(const ShelfCard& card, bool lacks_rings);
  /// A hand of the visitor is at the pot: from now on there is something to lose.
  void touch_pot();
  bool unkept() const { return touched && kept == Kept::not_asked; }
  /// Fresh clay comes to the wheel: it is nobody's work, and a lesson that goes on begins anew.
  void fresh_clay();
  /// The pot to decorate, made at the first call for it; null if the vessel has no way, or the pot
  /// no outline.
  decorating::DecoratedPot* pot_to_decorate();
  /// Requests the keepsake, once for each pot, decoration and glaze.
  void keep_pot();
  /// Requests a fresh lump; pot_ready() is false until it is on the wheel.
  void start_pot(int index, bool scripted, const std::string& script = "follow");
  bool pot_ready() const { return !awaited_; }
  /// Language key of the notice that replaces the hint: a fault, else device news; empty if none.
  const std::string& note() const;
  /// Call once a frame: reads the state of the wheel.
  void look();

 private:
  bool does(settings::Mission::Kind kind) const { return on() != nullptr && on()->kind == kind; }

  /// The surface of the pot that is decorated; 0: none.
  std::uint64_t decoration_hash() const;

  int kept_glaze_ = -1;                   ///< The glaze of the last request,
  std::uint64_t kept_decoration_ = 0;     ///< and the decoration.
  std::uint64_t clay_decorated_ = 0;      ///< ClayView::change() of the decorated pot.
  std::optional<std::uint32_t> awaited_;  ///< Serial of the pot that is being replaced.
};

}  // namespace onggi::screens
