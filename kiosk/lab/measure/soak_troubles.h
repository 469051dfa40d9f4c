#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace onggi::measure {

/// Real troubles of an unattended kiosk, one of each every kEvery visits: the helper that writes
/// pictures is killed or hangs; the disk is full for a visit; the folder of keepsakes is removed; a
/// curator's change of the exhibit is good, broken or fixed. Everything happens in the soak's own
/// folder. Main thread.
class SoakTroubles {
 public:
  static constexpr int kEvery = 24;  ///< Visits.

  enum class Kind {
    none,
    helper_killed,
    helper_hangs,  ///< Once: it takes the helper's whole time limit.
    disk_full,
    folder_removed,
    exhibit_changed,
    exhibit_broken,
    exhibit_mended,
  };

  /// `exhibit`: the soak's own exhibit.toml; `keepsakes`: its folder.
  SoakTroubles(std::filesystem::path exhibit, std::filesystem::path keepsakes);
  /// Restores the disk.
  ~SoakTroubles();
  SoakTroubles(const SoakTroubles&) = delete;
  SoakTroubles& operator=(const SoakTroubles&) = delete;

  /// Call before visit `n` (0, 1, ...) begins.
  void before(int n);
  /// Call once a frame of a visit; `saving`: its keepsake is being made.
  void during(bool saving);
  /// The visitor has left.
  void after();

  /// This visit's trouble.
  Kind kind() const { return kind_; }
  /// True if this visit's keepsake may be refused, because the disk is full. A helper that dies
  /// does not count, because another one does its work.
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
