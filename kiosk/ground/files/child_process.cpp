#include "kiosk/ground/files/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <utility>

namespace onggi::files {
namespace {

bool unblock(int fd) {
  const int flags = ::fcntl(fd, F_GETFL);
  return flags >= 0 && ::fcntl(fd, F_SETFL, flags | O_NONBLOCK) == 0;
}

}  // namespace

bool Channel::open_for_writing() {
  int pair[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair) != 0) return false;
  ours = Descriptor(pair[0]);
  theirs = Descriptor(pair[1]);
  return unblock(pair[0]);
}

bool Channel::open_for_reading() {
  int pair[2];
  if (::pipe2(pair, O_CLOEXEC) != 0) return false;
  ours = Descriptor(pair[0]);
  theirs = Descriptor(pair[1]);
  return unblock(pair[0]);
}

tl::expected<ChildProcess, int> ChildProcess::start(const std::string& program,
                                                    const std::vector<std::string>& arguments,
                                                    const Streams& streams) {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  if (const int failed = ::posix_spawn_file_actions_init(&files)) return tl::unexpected(failed);
  if (const int failed = ::posix_spawnattr_init(&attributes)) {
    ::posix_spawn_file_actions_destroy(&files);
    return tl::unexpected(failed);
  }
  int error = 0;
  const Descriptor nowhere(::open("/dev/null", O_RDWR | O_CLOEXEC));
  if (!nowhere.open()) error = errno;
  // Use only numbers above 2: if a standard descriptor is closed, a new pipe end could get the
  // number 0, 1 or 2.
  std::array<Descriptor, 3> high;
  const std::array<int, 3> wanted{streams.in, streams.out, streams.err};
  for (std::size_t i = 0; i < 3 && error == 0; ++i) {
    high[i] = Descriptor(::fcntl(wanted[i] < 0 ? nowhere.get() : wanted[i], F_DUPFD_CLOEXEC, 3));
    if (!high[i].open()) error = errno;
  }
  for (std::size_t i = 0; i < 3 && error == 0; ++i)
    error = ::posix_spawn_file_actions_adddup2(&files, high[i].get(), static_cast<int>(i));
  if (error == 0) error = ::posix_spawn_file_actions_addclosefrom_np(&files, 3);
  sigset_t none, all;
  ::sigemptyset(&none);
  ::sigfillset(&all);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  ::posix_spawnattr_setsigdefault(&attributes, &all);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);

  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  pid_t pid = -1;
  if (error == 0)
    error = ::posix_spawnp(&pid, program.c_str(), &files, &attributes, pointers.data(), environ);
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&files);
  if (error != 0) return tl::unexpected(error);
  return ChildProcess(pid);
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)), status_(other.status_) {}

ChildProcess::~ChildProcess() { end(SIGKILL); }

void ChildProcess::end(int signal, double patience) {
  if (pid_ <= 0) return;
  ::kill(pid_, signal);
  const auto most =
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(patience));
  if (wait_until(Clock::now() + most)) return;
  ::kill(pid_, SIGKILL);
  while (::waitpid(pid_, &status_, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
}

double ChildProcess::processor_seconds() const {
  clockid_t clock{};
  timespec used{};
  if (pid_ <= 0 || ::clock_getcpuclockid(pid_, &clock) != 0 || ::clock_gettime(clock, &used) != 0)
    return 0;
  return static_cast<double>(used.tv_sec) + static_cast<double>(used.tv_nsec) * 1e-9;
}

bool ChildProcess::wait_until(Clock::time_point deadline) {
  for (;;) {
    const pid_t ended = ::waitpid(pid_, &status_, WNOHANG);
    if (ended == pid_ || (ended < 0 && errno != EINTR)) {
      pid_ = -1;
      return true;
    }
    if (Clock::now() >= deadline) return false;
    const timespec moment{0, 2'000'000};
    ::nanosleep(&moment, nullptr);
  }
}

}  // namespace onggi::files
