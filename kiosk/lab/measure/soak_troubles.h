#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace onggi::measure {

/// What befalls a kiosk in days that nobody looks at it, put in for real, each every kEvery visits:
/// the helper that writes pictures is killed at work, or hangs; the disk takes nothing for a visit;
/// the folder of keepsakes is removed; a curator's change of the exhibit is good, is broken, is
/// mended. All of it lies in the soak's own folder. Main thread.
class SoakTroubles {
 public:
  static constexpr int kEvery = 24;  ///< Visits.

  enum class Kind {
    none,
    helper_killed,
    helper_hangs,  ///< Once: it costs the visitor the helper's deadline.
    disk_full,
    folder_removed,
    exhibit_changed,
    exhibit_broken,
    exhibit_mended,
  };

  /// `exhibit`: the soak's own exhibit.toml; `keepsakes`: its folder.
  SoakTroubles(std::filesystem::path exhibit, std::filesystem::path keepsakes);
  /// The disk is as it was.
  ~SoakTroubles();
  SoakTroubles(const SoakTroubles&) = delete;
  SoakTroubles& operator=(const SoakTroubles&) = delete;

  /// Before visit `n` (0, 1, ...) begins.
  void before(int n);
  /// Once a frame of a visit; `saving`: its keepsake is being made.
  void during(bool saving);
  /// The visitor has left.
  void after();

  /// This visit's.
  Kind kind() const { return kind_; }
  /// This visit's keepsake may be refused: the disk takes nothing. A helper that dies does not
  /// count: another does its work.
  bool may_refuse() const;
  /// "12 x the disk took nothing", in the order of Kind.
  std::vector<std::string> told() const;

 private:
  void write_exhibit(const std::string& text) const;
  bool signal_helper(int which) const;

  std::filesystem::path exhibit_, keepsakes_;
  std::string good_text_;
  Kind kind_ = Kind::none;
  bool done_ = false;
  std::map<Kind, int> count_;
};

}  // namespace onggi::measure
