#include "kiosk/program/watch/state_board.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <tuple>
#include <utility>

namespace onggi::watch {

namespace {

constexpr double kAgain = 1.0;  // s, after a write that failed

/// All but counts and times.
auto news_of(const KioskState& s) {
  return std::tuple(s.open, s.visitor, s.ended, s.vessel, s.devices, s.way_in, s.health.dark,
                    s.health.not_kept, s.trouble ? s.trouble->count : 0);
}

}  // namespace

StateBoard::StateBoard(std::filesystem::path keepsakes)
    : keepsakes_(std::move(keepsakes)), thread_([this] { attend(); }) {}

StateBoard::~StateBoard() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    if (state_) state_->ended = true;
  }
  wake_.notify_one();
  thread_.join();
}

void StateBoard::show(KioskState state) {
  {
    const std::lock_guard lock(mutex_);
    const bool news = !state_ || news_of(*state_) != news_of(state);
    state_ = std::move(state);
    if (!news) return;
  }
  wake_.notify_one();
}

void StateBoard::attend() {
  std::optional<KioskState> last;
  bool written = true;
  std::unique_lock lock(mutex_);
  for (;;) {
    wake_.wait_for(lock, std::chrono::duration<double>(written ? kEvery : kAgain), [&] {
      return ending_ || (state_ && (!last || news_of(*last) != news_of(*state_)));
    });
    const bool ending = ending_;
    if (state_) {
      last = state_;
      lock.unlock();
      written = write(*last);
      lock.lock();
    }
    if (ending) return;
  }
}

bool StateBoard::hold_file() {
  const std::filesystem::path path = keepsakes_ / kStateFile;
  // Somebody may have emptied the folder, or put another file there.
  struct stat named {
  }, own{};
  if (file_.open() && ::lstat(path.c_str(), &named) == 0 && ::fstat(file_.get(), &own) == 0 &&
      named.st_ino == own.st_ino && named.st_dev == own.st_dev)
    return true;
  files::Descriptor file(
      ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0644));
  if (!file.open() || ::flock(file.get(), LOCK_EX | LOCK_NB) != 0) return false;
  struct stat info {};
  if (::fstat(file.get(), &info) != 0 || !S_ISREG(info.st_mode)) return false;
  written_ = static_cast<std::size_t>(info.st_size);
  // None of ours is so long.
  if (written_ > kMostOfAState) {
    if (::ftruncate(file.get(), 0) != 0) return false;
    written_ = 0;
  }
  file_ = std::move(file);
  return true;
}

bool StateBoard::write(const KioskState& state) {
  if (!hold_file()) return false;
  std::string text = text_of(state);
  // What stands after the last line is not read: the file keeps its size, and its blocks.
  if (text.size() < written_) text.resize(written_, '\n');
  const ssize_t n = ::pwrite(file_.get(), text.data(), text.size(), 0);
  if (n > 0) written_ = std::max(written_, static_cast<std::size_t>(n));
  return n == static_cast<ssize_t>(text.size());
}

}  // namespace onggi::watch
