#pragma once

#include <cstdint>
#include <ctime>
#include <deque>
#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/collection/textures/texture_pixels.h"
#include "kiosk/keepsake/souvenir/small_pot.h"
#include "kiosk/picture/render/renderer.h"
#include "kiosk/visit/screens/todays_pot.h"

namespace onggi::exhibit {

/// Today's pots for the gallery. It reads the folder of keepsakes every kLook, so that a pot that
/// is deleted, expired or over the quota disappears at once, and all of them at midnight. A worker
/// reads folder and pictures, each picture once, with the helper onggi-texture; the main thread
/// sends one picture a frame to the renderer.
class TodaysPots {
 public:
  static constexpr double kLook = 1.0;  ///< s
  static constexpr std::size_t kMost = screens::kMostTodays;

  using Encoded = std::vector<std::span<const std::uint8_t>>;
  /// Reads the pixels of each; Problem if the helper failed.
  using Reader = std::function<Result<std::vector<textures::Decoded>>(const Encoded&)>;

  /// `wall`: the wall clock. `read`: reads pictures with the helper, on a worker; one bad picture
  /// does not affect the others.
  TodaysPots(std::filesystem::path folder, std::function<std::time_t()> wall,
             Reader read = by_helper)
      : folder_(std::move(folder)), wall_(std::move(wall)), read_(std::move(read)) {}
  ~TodaysPots();

  /// Call once a frame. `now` in s on a clock that never goes back. `wait`: for the worker and all
  /// pictures (a stepped kiosk).
  void look(double now, render::Renderer& renderer, bool wait = false);
  /// Looks again at once, because a pot was kept.
  void hurry() { looked_at_ = -kLook; }
  /// Newest first; not movable.
  const std::vector<screens::TodaysPot>& pots() const { return pots_; }

 private:
  /// A worker's result: the pots, and the new pictures; absent: damaged.
  struct Found {
    std::vector<souvenir::KeptPot> pots;
    std::map<std::string, view::Image> pictures;  ///< By visit and revision.
  };
  static std::string key_of(const souvenir::KeptPot& pot) { return pot.visit + ' ' + pot.revision; }
  static Result<std::vector<textures::Decoded>> by_helper(const Encoded& pictures);
  static Found find(const std::filesystem::path& folder, std::time_t now,
                    const std::vector<std::string>& known, const Reader& read);
  void take(Found found, render::Renderer& renderer);
  void show();

  std::filesystem::path folder_;
  std::function<std::time_t()> wall_;
  Reader read_;
  std::future<Found> finding_;
  double looked_at_ = -kLook;
  std::vector<souvenir::KeptPot> kept_;
  std::map<std::string, view::PictureId> pictures_;              ///< 0: it cannot be shown.
  std::deque<std::pair<std::string, view::Image>> to_be_shown_;  ///< By key.
  std::vector<screens::TodaysPot> pots_;
};

}  // namespace onggi::exhibit
