#pragma once

#include <filesystem>
#include <future>
#include <memory>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "kiosk/exhibit/composition/check_exhibit.h"
#include "kiosk/ground/files/file_stamps.h"
#include "kiosk/ground/files/file_watch.h"

namespace onggi::exhibit {

/// Notices changed files of the museum's exhibit (exhibit, scenes, devices, shelf, languages,
/// glazes, lesson, missions), and checks them like `onggi check` before they are opened. One for
/// the process: it continues while the exhibit is reopened. A worker reads files; look() never
/// waits for it. Main thread.
class Reload {
 public:
  /// The exhibit on the screen from now on.
  enum class Shown {
    this_one,  ///< `exhibit` as it is on the disk; its current Problems are known.
    another,   ///< A safer one: `exhibit` is taken when it has changed and its own file is valid.
  };
  /// `exhibit` is the museum's exhibit.toml. Create it before that is opened.
  Reload(std::filesystem::path exhibit, Shown shown);
  ~Reload();

  /// Call once a frame, except while the shelf is being read; `now` in seconds, never going back.
  /// Logs what a change broke; the open exhibit then stays.
  void look(double now);
  /// True if a change has settled and broke nothing that worked before.
  bool wanted() const;
  /// The changed exhibit is opened now.
  void taken_up();

 private:
  struct Checked {
    Result<CheckReport> report;
    std::vector<std::filesystem::path> folders;
    files::Stamps before, after;  ///< File stamps when the check began, and when it ended.
  };

  void begin_check();
  void take(const Checked& checked, double now);
  void judge(const CheckReport& report, double now);
  void refuse(const CheckReport& report, double now);
  bool new_to_visitors(const Problem& problem) const;

  std::filesystem::path exhibit_;
  bool stands_in_;  ///< An exhibit other than `exhibit_` is open.
  std::unique_ptr<files::FileWatch> files_;
  std::stop_source stop_;
  std::future<Checked> check_;
  files::Stamps open_;  ///< Stamps of the open exhibit; before the first check, of all files there,
  files::Stamps seen_;  ///< and of the last check.
  std::set<std::string> known_;    ///< Problems of the open exhibit,
  std::set<std::string> found_;    ///< of the last check,
  std::set<std::string> refused_;  ///< and of the last refused change.
  std::string trouble_;            ///< Why the last check failed; "" if it did not.
  bool checked_ = false, wanted_ = false, again_ = true;
  double look_again_at_ = -1.0;  ///< Below 0: not before a change.
};

}  // namespace onggi::exhibit
