#pragma once

#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/souvenir/keepsake.h"

namespace onggi::exhibit {

/// Saves keepsakes on a worker, one at a time in order, so that the screen never waits for a disk,
/// and tidies their folder (souvenir::tidy) at once, at each save and every kTidy. A save that has
/// begun is finished even when the program ends. Main thread.
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
  /// Waits for all saves that have begun.
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
  std::shared_future<Result<void>> tidying_;
  std::optional<double> tidied_at_;
  bool told_ = false;  ///< What tidying_ came to.
};

}  // namespace onggi::exhibit
