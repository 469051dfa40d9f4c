#pragma once

#include <filesystem>
#include <future>
#include <memory>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "kiosk/exhibit/composition/check_exhibit.h"
#include "kiosk/ground/files/file_watch.h"
#include "kiosk/ground/files/stamp.h"

namespace onggi::exhibit {

/// Notices that the files of the museum's exhibit have changed (exhibit, scenes, devices, shelf,
/// languages, glazes, lesson, missions), and checks them, as `onggi check` does, before anybody
/// opens them. One for the process: it goes on while the exhibit is opened anew. Files are read on
/// a worker; look() never waits for one. Main thread.
class Reload {
 public:
  /// What is on the screen from now on.
  enum class Shown {
    this_one,  ///< `exhibit`, as it lies on the disk now: what is wrong with it now is known.
    another,   ///< A safer one: `exhibit` is taken up once it has changed and its own file is good.
  };
  /// `exhibit` is the museum's exhibit.toml; made before it is opened.
  Reload(std::filesystem::path exhibit, Shown shown);
  ~Reload();

  /// Once a frame, while the shelf need not be read besides; `now` in seconds, never going back.
  /// Logs what a change broke: what is open goes on as it was.
  void look(double now);
  /// A change has come to rest on the disk, and it broke nothing that was good before.
  bool wanted() const;
  /// It is what is opened now.
  void taken_up();

 private:
  struct Checked {
    Result<CheckReport> report;
    std::vector<std::filesystem::path> folders;
    files::Stamps before, after;  ///< What stood in them as the check began, and as it ended.
  };

  void begin_check();
  void take(const Checked& checked, double now);
  void judge(const CheckReport& report, double now);
  void refuse(const CheckReport& report, double now);
  bool new_to_visitors(const Problem& problem) const;

  std::filesystem::path exhibit_;
  bool stands_in_;  ///< Another than `exhibit_` is open.
  std::unique_ptr<files::FileWatch> files_;
  std::stop_source stop_;
  std::future<Checked> check_;
  files::Stamps open_;  ///< Of what is open; before the first check, of all that lay there,
  files::Stamps seen_;  ///< and of what was checked last.
  std::set<std::string> known_;    ///< Problems of what is open,
  std::set<std::string> found_;    ///< of what was checked last,
  std::set<std::string> refused_;  ///< and of the change last refused.
  std::string trouble_;            ///< Why the last check could not be made; "" where it could.
  bool checked_ = false, wanted_ = false, again_ = true;
  double look_again_at_ = -1.0;  ///< Below 0: not before something changes.
};

}  // namespace onggi::exhibit
