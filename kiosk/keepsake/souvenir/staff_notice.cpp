#include "kiosk/keepsake/souvenir/staff_notice.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>

namespace onggi::souvenir {

namespace {

constexpr std::size_t kMostOfAnAddress = 300;

}  // namespace

bool StaffNotice::put_up(const std::string& address) {
  std::error_code gone;
  if (held_.open() && std::filesystem::exists(file_, gone)) return true;  // nobody deleted it
  files::Descriptor file(
      ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0644));
  if (!file.open() || ::flock(file.get(), LOCK_EX | LOCK_NB) != 0) return false;
  if (::ftruncate(file.get(), 0) != 0 || ::pwrite(file.get(), address.data(), address.size(), 0) !=
                                             static_cast<ssize_t>(address.size()))
    return false;
  held_ = std::move(file);
  return true;
}

void StaffNotice::take_away() {
  if (!held_.open()) return;
  ::unlink(file_.c_str());
  held_ = files::Descriptor();
}

std::string address_for_staff(const std::filesystem::path& keepsakes) {
  const files::Descriptor file(
      ::open((keepsakes / ".staff").c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  if (!file.open() || ::flock(file.get(), LOCK_SH | LOCK_NB) == 0) return {};
  std::array<char, kMostOfAnAddress> text{};
  const ssize_t n = ::pread(file.get(), text.data(), text.size(), 0);
  const std::string address(text.data(), static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
  const bool plain = std::ranges::all_of(address, [](char c) { return c > ' ' && c < 0x7F; });
  return plain && address.starts_with("http") ? address : std::string();
}

}  // namespace onggi::souvenir
