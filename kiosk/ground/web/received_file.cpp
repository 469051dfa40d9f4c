#include "kiosk/ground/web/received_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "kiosk/ground/files/durable_file.h"

namespace onggi::web {

namespace {

namespace fs = std::filesystem;

constexpr const char* kBegin = "onggi-received-";
constexpr const char* kEnd = ".part";
// A process often has the number of one that was killed and left its file.
constexpr int kMostLeftBehind = 1000;

bool is_abandoned(const fs::path& file) {
  const files::Descriptor one(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  struct stat info {};
  return one.open() && ::fstat(one.get(), &info) == 0 && S_ISREG(info.st_mode) &&
         ::flock(one.get(), LOCK_EX | LOCK_NB) == 0;
}

}  // namespace

Result<std::shared_ptr<ReceivedFile>> ReceivedFile::make(const IntoFile& into) {
  static std::atomic<unsigned> count{0};
  for (int tries = 0;; ++tries) {
    fs::path path = into.folder / (kBegin + std::to_string(::getpid()) + '-' +
                                   std::to_string(count.fetch_add(1)) + kEnd);
    files::Descriptor file(
        ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0600));
    if (!file.open() && errno == EEXIST && tries < kMostLeftBehind) continue;
    if (!file.open()) return tl::unexpected(files::disk_problem(path, "write", errno));
    // Nobody else knows the name yet. Where a disk has no locks, nothing is ever abandoned.
    static_cast<void>(::flock(file.get(), LOCK_EX | LOCK_NB));
    return std::shared_ptr<ReceivedFile>(
        new ReceivedFile(std::move(path), std::move(file), into.ticket));
  }
}

ReceivedFile::~ReceivedFile() {
  if (!path_.empty()) ::unlink(path_.c_str());
}

bool ReceivedFile::append(std::span<const std::byte> bytes) {
  if (!files::write_all(file_.get(), bytes)) return false;
  size_ += bytes.size();
  return true;
}

Result<void> ReceivedFile::move_to(const fs::path& to) {
  if (::rename(path_.c_str(), to.c_str()) != 0)
    return tl::unexpected(files::disk_problem(to, "write", errno));
  path_.clear();
  return {};
}

std::size_t remove_abandoned(const fs::path& folder) {
  std::size_t removed = 0;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (name.starts_with(kBegin) && name.ends_with(kEnd) && is_abandoned(at->path()) &&
        ::unlink(at->path().c_str()) == 0)
      ++removed;
  }
  return removed;
}

}  // namespace onggi::web
