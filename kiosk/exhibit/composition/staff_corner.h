#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "kiosk/collection/content/language.h"
#include "kiosk/picture/view/frame.h"
#include "kiosk/picture/view/input.h"

namespace onggi::exhibit {

/// A way into the staff's page that the screen showed.
struct WayIn {
  std::string digest;      ///< Of its code (secrets::digest_of()).
  std::int64_t until = 0;  ///< s since 1970.
  friend bool operator==(const WayIn&, const WayIn&) = default;
};

/// Shows the museum's staff their first way into the staff's page: whoever holds a corner of the
/// screen for kHold gets an address with a code, on the whole screen. Only while that page waits
/// for its first name (souvenir::StaffNotice); else, and for each shorter touch, a corner is like
/// the rest of the screen. Main thread.
class StaffCorner {
 public:
  static constexpr double kHold = 5.0;     ///< s
  static constexpr double kShown = 120.0;  ///< s, or until the next touch.

  /// `keepsakes`: their folder. `wall`: the clock on the wall, s since 1970.
  StaffCorner(std::filesystem::path keepsakes, std::function<std::int64_t()> wall)
      : keepsakes_(std::move(keepsakes)), wall_(std::move(wall)) {}

  /// What the others get of `event`, in a window of this size: itself, nothing while it may become
  /// a hold, or the touch that it was after all.
  std::vector<view::InputEvent> pass(const view::InputEvent& event, int width, int height,
                                     double now);
  /// Once a frame, before it is drawn: covers `frame` while the address is shown.
  void draw(view::Frame& frame, const content::Language& language, double now);
  /// The newest one.
  const std::optional<WayIn>& way_in() const { return way_in_; }

 private:
  void show(double now);

  std::filesystem::path keepsakes_;
  std::function<std::int64_t()> wall_;
  std::optional<view::InputEvent> held_;  ///< The touch that may become a hold,
  double since_ = 0.0;                    ///< since when, s.
  std::string address_, shown_;           ///< The page's; with the code, while it is shown.
  double shown_since_ = 0.0;              ///< s
  bool lifted_ = false;                   ///< The finger that held has gone.
  std::optional<WayIn> way_in_;
};

}  // namespace onggi::exhibit
