#pragma once

#include <filesystem>
#include <future>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/keepsake/souvenir/keepsake.h"
#include "kiosk/keepsake/souvenir/turning.h"

namespace onggi::exhibit {

/// Saves keepsakes on a worker, one at a time in order, so that the screen never waits for a disk,
/// and tidies their folder (souvenir::tidy) at once, at each save and every kTidy. A save that has
/// begun is finished even when the program ends. A turning picture follows its save and is waited
/// for by no other. Main thread.
class Keepsakes {
 public:
  static constexpr double kTidy = 24 * 3600.0;  ///< s

  /// With `phone_hours` over 0 phones may fetch a keepsake for so long.
  Keepsakes(std::filesystem::path folder, souvenir::KeepsakeLimits limits,
            double phone_hours = 0.0);
  ~Keepsakes();

  /// A token for the next keepsake, for its postcard's code; "" where no phone may fetch it or none
  /// is answered now.
  std::string token() const;
  /// Begins a save; the ticket (> 0) names it in finished().
  int save(souvenir::Keepsake keepsake);

  struct Finished {
    int ticket = 0;
    Result<souvenir::KeepsakeFiles> outcome;
  };
  /// The oldest save that has come to an end, once each.
  std::optional<Finished> finished();
  bool busy() const { return !saving_.empty(); }
  /// Adds `turning` to the keepsake that `ticket`'s save made, once it is made; to none, where it
  /// failed.
  void add(int ticket, encoding::Turning turning, encoding::Caption caption);
  struct Added {
    int ticket = 0;
    Result<std::filesystem::path> outcome;  ///< The file.
  };
  /// The next turning picture that has come to an end, once each.
  std::optional<Added> added();
  bool adding() const { return !adding_.empty(); }
  /// Waits for all saves and turning pictures that have begun.
  void wait() const;
  /// Once a frame. `now` in seconds on a clock that never goes back.
  void look(double now);
  /// What the last tidying could not do; once.
  std::optional<Problem> untidy();
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
  souvenir::KeepsakeLimits limits_;
  double phone_hours_;
  int tickets_ = 0;
  std::vector<std::shared_future<Finished>> saving_;
  /// The last save, which finished() may have told already: its turning picture comes later.
  std::pair<int, std::shared_future<Finished>> last_save_;
  std::vector<std::future<Added>> adding_;
  std::mutex folder_in_use_;  ///< One worker at a time writes there; pictures are encoded before.
  std::shared_future<Result<void>> tidying_;
  std::optional<double> tidied_at_;
  bool told_ = false;  ///< What tidying_ came to.
};

}  // namespace onggi::exhibit
