#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/ground/web/message.h"
#include "kiosk/program/console/onggi_process.h"

namespace onggi::console {

/// One scan on its way to the shelf: its files as they arrived, what is in them, and the vessel
/// that is made of it. It lies in a folder of the page's own until it is on the shelf. The program
/// `onggi` reads it, in a process of its own, which no file can make work for long. One thread;
/// never waits for that process.
class ScanInbox {
 public:
  static constexpr std::uint64_t kMost = 512u << 20;  ///< Bytes of a file.
  static constexpr std::size_t kMostFiles = 300;

  /// `onggi`: the program beside this one. `folder`: of its own; emptied now.
  ScanInbox(std::filesystem::path onggi, std::filesystem::path folder);

  /// Where the next file goes; an Answer while another one arrives or is worked on.
  web::BodyPlace place_for_file();
  /// Takes a file that arrived, under its `name`, which may have folders. `first`: it begins
  /// another scan. Problem: a name that leads out, or too many files (exit 2); the disk (exit 1).
  Result<void> take(web::ReceivedFile& file, const std::string& name, bool first);
  /// Begins to read what has arrived; false while something else is done.
  bool look();
  /// What somebody chose of what is in doubt.
  struct Choice {
    std::size_t vessel = 0;    ///< Of those that were found.
    std::string id;            ///< Its folder on the shelf.
    bool turned_over = false;  ///< It stands the other way up than was found.
    double height_mm = 0.0;    ///< 0: as the file has it.
  };
  /// The number of the scan that is here: whoever chooses means one of them.
  int number() const { return number_; }
  /// Begins to put it on `shelf`. False while something else is done, or where there is no such
  /// vessel.
  bool put_on_shelf(const Choice& choice, const std::filesystem::path& shelf);
  /// Deletes what has arrived; false while something is done with it.
  bool forget();

  /// {scan: its number, name: of its first file, files: how many, bytes, most, free: bytes on the
  /// disk, doing: "", "looking" or "placing", found: what `onggi vessel look` told, placed: what
  /// `onggi vessel import` told, id: of that}
  std::string json();
  /// Something is done with a scan.
  bool under_way() const { return onggi_.under_way(); }
  /// The vessel that came onto the shelf since the last call, once: for the log.
  std::optional<std::string> put();

 private:
  enum class Doing { nothing, looking, placing };
  void take_answer();

  OnggiProcess onggi_;
  std::filesystem::path folder_, scan_;
  std::weak_ptr<void> arriving_;
  Doing doing_ = Doing::nothing;
  int number_ = 0;
  std::string name_;
  std::size_t files_ = 0;
  std::uint64_t bytes_ = 0;
  std::string found_, placed_, id_;  // JSON; "": nothing yet
  std::optional<std::string> put_;
};

}  // namespace onggi::console
