#pragma once

#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/souvenir/keepsake.h"

namespace onggi::app {

/// Saves keepsakes on a worker, one at a time in order, so that the screen never waits for a disk.
/// A save that has begun is finished even when the program ends.
class Keepsakes {
 public:
  Keepsakes(std::filesystem::path folder, int quota_mb);
  ~Keepsakes();

  void save(souvenir::Keepsake keepsake);
  /// The outcome of the oldest save that has come to an end, once each.
  std::optional<Result<souvenir::KeepsakeFiles>> finished();
  bool busy() const { return !saving_.empty(); }

 private:
  std::filesystem::path folder_;
  int quota_mb_;
  std::vector<std::shared_future<Result<souvenir::KeepsakeFiles>>> saving_;
};

}  // namespace onggi::app
