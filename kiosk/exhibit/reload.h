#pragma once

#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "kiosk/exhibit/check_exhibit.h"
#include "kiosk/watch/file_watch.h"

namespace onggi::exhibit {

/// Notices that the files of the open exhibit have changed (exhibit, scenes, shelf, languages,
/// glazes, lessons), and checks them, as `onggi check` does, before anybody opens them. Files are
/// read on a worker; look() never waits for one. Main thread.
class Reload {
 public:
  /// `exhibit` is the exhibit.toml that is open.
  explicit Reload(std::filesystem::path exhibit);
  ~Reload();

  /// Once a frame; `now` in seconds, never going back. Logs what a change broke: the open exhibit
  /// goes on as it was.
  void look(double now);
  /// A change is on the disk, and it broke nothing that was good before.
  bool wanted() const { return wanted_; }

 private:
  void begin_check();
  void take(const CheckReport& report, double now);
  void refuse(const CheckReport& report, std::set<std::string> found, double now);

  std::filesystem::path exhibit_;
  std::unique_ptr<watch::FileWatch> files_;
  std::stop_source stop_;
  std::future<Result<CheckReport>> check_;
  std::optional<std::set<std::string>> known_;  ///< Problems of the exhibit that is open,
  std::set<std::string> refused_;               ///< and of the change last refused.
  bool wanted_ = false, again_ = false;
  double look_again_at_ = -1.0;  ///< Below 0: not before something changes.
};

}  // namespace onggi::exhibit
