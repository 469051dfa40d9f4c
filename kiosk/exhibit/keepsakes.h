#pragma once

#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/souvenir/keepsake.h"

namespace onggi::exhibit {

/// Saves keepsakes on a worker, one at a time in order, so that the screen never waits for a disk.
/// A save that has begun is finished even when the program ends.
class Keepsakes {
 public:
  Keepsakes(std::filesystem::path folder, int quota_mb);
  ~Keepsakes();

  /// Begins a save; the ticket (> 0) names it in finished().
  int save(souvenir::Keepsake keepsake);

  struct Finished {
    int ticket = 0;
    Result<souvenir::KeepsakeFiles> outcome;
  };
  /// The oldest save that has come to an end, once each.
  std::optional<Finished> finished();
  bool busy() const { return !saving_.empty(); }
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
  int quota_mb_;
  int tickets_ = 0;
  std::vector<std::shared_future<Finished>> saving_;
};

}  // namespace onggi::exhibit
