#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "kiosk/ground/web/message.h"
#include "kiosk/program/console/screen_drawer.h"
#include "kiosk/program/console/site.h"

namespace onggi::console {

/// The part of the staff's page that shows screens as visitors see them, or would after a change
/// that is not saved yet. A visitor comes first: nothing is drawn while one plays. One thread;
/// reads the disk.
class ScreenAnswers {
 public:
  /// Of so many drawings the pictures are kept, the newest.
  static constexpr std::size_t kKept = 4;
  /// Seconds without a question for it after which a drawing is not wanted any more.
  static constexpr std::int64_t kForgotten = 10;

  /// `site` stays with the caller.
  ScreenAnswers(Site& site, ScreenDrawer drawer) : site_(site), drawer_(std::move(drawer)) {}

  /// Begins to draw. `body`: {screen, language, vessel, comfort: of onggi screen, "" for none,
  /// file, changes: of a file as it is edited (EditAnswers)}. 202 {number}; 409 with {visitor:
  /// true} while somebody plays, with {faults} for a change that cannot be; 503 while another is
  /// drawn.
  web::Answer draw(const web::Ask& ask);
  /// Of the drawing ?number=: {drawing, pictures: [{at, width, height}], what, remedy, visitor: it
  /// was ended for one}
  web::Answer drawn(const web::Ask& ask);
  /// The picture `part` of the drawing `number`, a JPEG.
  web::Answer picture(const std::string& number, const std::string& part) const;
  /// Ends the one under way, if there is one.
  web::Answer stop();

 private:
  bool visitor_plays() const;
  void take();

  /// What the thread that waits for a drawing reads.
  struct Wanted {
    std::atomic<bool> stopped = false;
    std::atomic<std::int64_t> asked_at = 0;  ///< s of a steady clock.
  };

  Site& site_;
  ScreenDrawer drawer_;
  std::shared_ptr<Wanted> wanted_;
  int number_ = 0;  ///< Of the newest drawing.
  std::map<int, DrawnScreen> kept_;
};

}  // namespace onggi::console
