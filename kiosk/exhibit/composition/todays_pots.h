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

/// The pots that were kept today, for the gallery: looked for in the folder of keepsakes every
/// kLook, so that one that is deleted, expired or beyond the quota is gone from it at once, and all
/// of them at midnight. Folder and pictures are read on a worker, each picture once, by the helper
/// onggi-texture; on the main thread one picture a frame goes to the renderer.
class TodaysPots {
 public:
  static constexpr double kLook = 1.0;       ///< s
  static constexpr std::size_t kMost = 120;  ///< The newest; a picture takes 0.4 MB.

  using Encoded = std::vector<std::span<const std::uint8_t>>;
  /// The pixels of each; a Problem where the helper that reads them did not end well.
  using Reader = std::function<Result<std::vector<textures::Decoded>>(const Encoded&)>;

  /// `wall`: the clock on the wall. `read`: by the helper, asked on a worker; one picture that ends
  /// it takes no other with it.
  TodaysPots(std::filesystem::path folder, std::function<std::time_t()> wall,
             Reader read = by_helper)
      : folder_(std::move(folder)), wall_(std::move(wall)), read_(std::move(read)) {}
  ~TodaysPots();

  /// Once a frame. `now` in s on a clock that never goes back. `wait`: for the worker, and for all
  /// pictures at once (a stepped kiosk).
  void look(double now, render::Renderer& renderer, bool wait = false);
  /// The next look is due at once: something was kept.
  void hurry() { looked_at_ = -kLook; }
  /// Newest first; stays where it is.
  const std::vector<screens::TodaysPot>& pots() const { return pots_; }

 private:
  /// What a worker found, and of those that had no picture yet what it looks like; none: damaged.
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
