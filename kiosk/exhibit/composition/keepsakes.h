#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <future>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/keepsake/souvenir/keepsake.h"
#include "kiosk/keepsake/souvenir/room.h"
#include "kiosk/keepsake/souvenir/turning.h"

namespace onggi::exhibit {

/// Saves keepsakes on a worker, one at a time in order, so that the screen never waits for a disk,
/// and tidies their folder (souvenir::tidy) at once, at each save and every kTidy. A save that has
/// begun is finished even when the program ends. The GIF is added after its save; later saves do
/// not wait for it. Main thread.
class Keepsakes {
 public:
  static constexpr double kTidy = 24 * 3600.0;  ///< s
  static constexpr double kRoom = 600.0;        ///< s, between two looks at the room for pages

  /// The id of a name that is not in `taken`, the same for the same `seed`; called on the worker.
  using Namer = std::function<std::string(std::uint64_t seed, const std::set<std::string>& taken)>;
  /// If `phone_hours` is over 0, phones may fetch a keepsake for that long. Without `namer`
  /// keepsakes have no names.
  Keepsakes(std::filesystem::path folder, souvenir::KeepsakeLimits limits, double phone_hours = 0.0,
            Namer namer = {});
  ~Keepsakes();

  /// A token for the next keepsake's QR code; "" if phones may not fetch it, nobody answers them
  /// now, or the quota has no room for one more that is promised.
  std::string token() const;
  /// Begins a save; returns its ticket (> 0) for finished(). `name_seed`: for the namer.
  int save(souvenir::Keepsake keepsake, std::uint64_t name_seed = 0);

  struct Finished {
    int ticket = 0;
    Result<souvenir::KeepsakeFiles> outcome;
  };
  /// The oldest finished save, each once.
  std::optional<Finished> finished();
  bool busy() const { return !saving_.empty(); }
  /// Adds `turning` to the keepsake of `ticket`'s save after that succeeds; does nothing if it
  /// failed.
  void add(int ticket, encoding::Turning turning, encoding::Caption caption);
  struct Added {
    int ticket = 0;
    Result<std::filesystem::path> outcome;  ///< The file.
  };
  /// The next finished turning picture, each once.
  std::optional<Added> added();
  bool adding() const { return !adding_.empty(); }
  /// Waits for all saves and turning pictures that have begun.
  void wait() const;
  /// Once a frame. `now` in seconds on a clock that never goes back.
  void look(double now);
  /// The room for pages when it was last looked at.
  std::optional<souvenir::Room> room() const;
  /// What staff must know of it (souvenir::warning_of), once a day, and at once when it is used up.
  std::optional<Problem> crowded(double now);
  /// The Problem of the last tidying, once.
  std::optional<Problem> untidy();
  const std::filesystem::path& folder() const { return folder_; }

 private:
  void look_for_room();  ///< A worker's.

  std::filesystem::path folder_;
  souvenir::KeepsakeLimits limits_;
  double phone_hours_;
  Namer namer_;
  int tickets_ = 0;
  std::vector<std::shared_future<Finished>> saving_;
  /// The last save, even after finished() returned it: its turning picture comes later.
  std::pair<int, std::shared_future<Finished>> last_save_;
  std::vector<std::future<Added>> adding_;
  std::mutex folder_in_use_;  ///< One worker at a time writes there; pictures are encoded before.
  std::shared_future<Result<void>> tidying_;
  std::optional<double> tidied_at_, looked_at_, warned_at_;
  bool warned_of_last_ = false;  ///< There was no page left to promise.
  mutable std::mutex room_in_use_;
  std::optional<souvenir::Room> room_;
  std::future<void> looking_;
  bool told_ = false;  ///< The result of tidying_ was reported.
};

}  // namespace onggi::exhibit
