#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "kiosk/collection/content/keepsake_names.h"
#include "kiosk/collection/content/language.h"
#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/exhibit/composition/keepsakes.h"
#include "kiosk/exhibit/composition/taken_home.h"
#include "kiosk/exhibit/composition/todays_pots.h"
#include "kiosk/exhibit/composition/turntable_recorder.h"
#include "kiosk/exhibit/composition/visit_counter.h"
#include "kiosk/picture/render/renderer.h"
#include "kiosk/visit/screens/visit.h"
#include "kiosk/wheel/loop/wheel_host.h"

namespace onggi::exhibit {

/// Keepsakes that were kept since the kiosk opened, and those that the disk refused.
struct SavedCount {
  std::uint64_t kept = 0, refused = 0;
};

/// One visitor's keepsake, from the postcard on the screen to the files on the disk and the count
/// of visits. Carries out the two wishes of a visit that concern it. Main thread; only finish()
/// waits for a disk.
class Keeping {
 public:
  /// What it works with; all of it outlives this. `todays`, `counter`: null where the exhibit shows
  /// no gallery, or counts no visits.
  struct World {
    const settings::Exhibit& exhibit;
    const std::vector<content::Language>& languages;
    const content::KeepsakeNames& names;
    render::Renderer& renderer;
    loop::WheelHost& wheel_host;
    TodaysPots* todays = nullptr;
    VisitCounter* counter = nullptr;
  };
  Keeping(const World& world, const std::filesystem::path& folder);

  /// Once a frame, first of all: tidies the folder when that is due, and logs what staff must know
  /// of it. `now` in seconds.
  void look(double now);
  /// The visitor keeps the pot that answers `card`: a keepsake that the next frames draw, its
  /// postcard first, and then save.
  void make(const screens::MakeKeepsake& wish, const screens::ShelfCard& card,
            screens::Visit& visit);
  /// The visit is over: it is counted with its save, and its postcard is dropped. `vessel`: its
  /// name on the shelf, "" where none was chosen.
  void forget(const screens::VisitEnded& wish, const std::string& vessel);
  /// Once a frame, after the clay was uploaded: one more step of the keepsake that is being made,
  /// so that no frame takes two. A step is a picture, a postcard's words, or the postcard on the
  /// screen. The save begins after the last one.
  void draw_keepsake(screens::Visit& visit);
  /// The clay on the wheel is about to change: draws all that is left at once.
  void draw_rest();
  /// Takes what workers have finished, and tells the gallery, the count of visits and the visitor,
  /// in this order. The visitor is told of their own save alone.
  void collect(screens::Visit& visit);
  /// One more picture of the turning pot, unless this frame drew one of a keepsake, and while no
  /// screen fades into another: `shown` is the frame that was just made, of the same clay.
  void draw_turning(const view::Frame& shown);
  /// Waits for every save, and for the count of visits. Draws nothing. Call once, at the end.
  void finish(screens::Visit& visit);
  /// The screen is lost. A keepsake that was being drawn is saved with what there is: the postcard,
  /// no model and no page. Without a postcard there is nothing to save.
  void lose_screen();

  const std::optional<KeptVisit>& kept() const { return kept_; }
  /// A keepsake is being drawn or saved.
  bool saving() const { return taking_ || keepsakes_.busy(); }
  /// A turning picture is being written.
  bool adding() const { return keepsakes_.adding(); }
  /// A turning picture is being drawn or written. It comes after its save, and nobody need wait.
  bool turning() const { return turning_.drawing() || adding(); }
  std::optional<souvenir::Room> room() const { return keepsakes_.room(); }
  const SavedCount& saved() const { return saved_; }
  const std::filesystem::path& folder() const { return keepsakes_.folder(); }

 private:
  void draw_next();
  void tell(const Keepsakes::Finished& save, screens::Visit& visit);

  World world_;
  Keepsakes keepsakes_;
  std::optional<TakingHome> taking_;
  /// Of the last keepsake; null: none. A visitor may leave while it is drawn.
  std::shared_ptr<decorating::DecoratedPot> decorated_;
  const decoration::CoatPicture* coat() const {
    return decorated_ ? &decorated_->picture() : nullptr;
  }
  bool left_handed_ = false;  ///< Its visitor's wheel,
  Profile made_;              ///< and pot.
  bool drew_ = false;         ///< A picture of a keepsake, in this frame.
  TurntableRecorder turning_;
  view::PictureId postcard_ = 0;  ///< On the screen; 0: none yet.
  std::optional<KeptVisit> kept_;
  int kept_ticket_ = 0;    ///< Of kept_'s save.
  int saving_ticket_ = 0;  ///< The present visitor's save; 0: none, or the visitor has left.
  SavedCount saved_;
};

}  // namespace onggi::exhibit
