#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "kiosk/ground/files/descriptor.h"

namespace onggi::souvenir {

/// s that a way in which the kiosk shows is good.
inline constexpr std::int64_t kWayInLasts = 3600;

/// What the program with the staff's page tells the kiosk, by the file `.staff` among the
/// keepsakes: that nobody has a name yet, and where the page is. The file is locked while that is
/// so, and counts for nothing otherwise. One thread.
class StaffNotice {
 public:
  explicit StaffNotice(std::filesystem::path keepsakes) : file_(std::move(keepsakes) / ".staff") {}
  ~StaffNotice() { take_away(); }
  StaffNotice(const StaffNotice&) = delete;
  StaffNotice& operator=(const StaffNotice&) = delete;

  /// Puts it up; `address` as a browser takes it, "https://kiosk.museum.org". False where the disk
  /// does not allow it.
  bool put_up(const std::string& address);
  void take_away();

 private:
  std::filesystem::path file_;
  files::Descriptor held_;
};

/// The address of a page that waits for its first name; "" where none does. Reads one small file.
std::string address_for_staff(const std::filesystem::path& keepsakes);

}  // namespace onggi::souvenir
