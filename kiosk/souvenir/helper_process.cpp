#include "kiosk/souvenir/helper_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

namespace onggi::souvenir {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kLastWords = 2000;  // of standard error that a Problem carries

/// Both ends of a pipe or socket pair: ours does not block, neither outlives an exec by accident.
struct Channel {
  int ours = -1, theirs = -1;
  ~Channel() {
    close_ours();
    close_theirs();
  }
  Channel() = default;
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;
  void close_ours() {
    if (ours >= 0) ::close(std::exchange(ours, -1));
  }
  void close_theirs() {
    if (theirs >= 0) ::close(std::exchange(theirs, -1));
  }
  /// What we write goes through a socket: send() can leave SIGPIPE out, write() cannot.
  bool open_for_writing() {
    int pair[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair) != 0) return false;
    ours = pair[0];
    theirs = pair[1];
    return unblock();
  }
  bool open_for_reading() {
    int pair[2];
    if (::pipe2(pair, O_CLOEXEC) != 0) return false;
    ours = pair[0];
    theirs = pair[1];
    return unblock();
  }

 private:
  bool unblock() const {
    const int flags = ::fcntl(ours, F_GETFL);
    return flags >= 0 && ::fcntl(ours, F_SETFL, flags | O_NONBLOCK) == 0;
  }
};

/// Starts `program` with `in`, `out`, `err` as its three descriptors. errno value, 0 is good.
int start(const std::filesystem::path& program, int in, int out, int err, pid_t& pid) {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  if (const int error = ::posix_spawn_file_actions_init(&files)) return error;
  if (const int error = ::posix_spawnattr_init(&attributes)) {
    ::posix_spawn_file_actions_destroy(&files);
    return error;
  }
  // Numbers above 2 are certain: with a standard descriptor closed, ours could be 0 to 2
  // themselves.
  const std::array<int, 3> wanted{in, out, err};
  std::array<int, 3> high{};
  int error = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    high[i] = ::fcntl(wanted[i], F_DUPFD_CLOEXEC, 3);
    if (high[i] < 0) error = errno;
  }
  for (std::size_t i = 0; i < 3 && error == 0; ++i) {
    error = ::posix_spawn_file_actions_adddup2(&files, high[i], static_cast<int>(i));
  }
  if (error == 0) error = ::posix_spawn_file_actions_addclosefrom_np(&files, 3);
  sigset_t none, all;
  ::sigemptyset(&none);
  ::sigfillset(&all);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  ::posix_spawnattr_setsigdefault(&attributes, &all);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  std::string name = program.string();
  char* const arguments[] = {name.data(), nullptr};
  if (error == 0) {
    error = ::posix_spawn(&pid, name.c_str(), &files, &attributes, arguments, environ);
  }
  for (const int fd : high) {
    if (fd >= 0) ::close(fd);
  }
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&files);
  return error;
}

/// The child until it has been waited for: killed and waited for on every way out.
class Child {
 public:
  explicit Child(pid_t pid) : pid_(pid) {}
  ~Child() { kill_and_wait(); }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  void kill_and_wait() {
    if (pid_ <= 0) return;
    ::kill(pid_, SIGKILL);
    while (::waitpid(pid_, &status_, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
  }
  /// True once it has ended; false at `deadline`.
  bool wait_until(Clock::time_point deadline) {
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
  int status() const { return status_; }

 private:
  pid_t pid_;
  int status_ = 0;
};

enum class Talk { done, late, too_much, broken };

/// Writes head and body, reads out and err, until the helper has closed both.
Talk talk(Channel& in, Channel& out, Channel& err, std::span<const std::byte> head,
          std::span<const std::byte> body, std::size_t most_bytes, Clock::time_point deadline,
          std::vector<std::byte>& output, std::string& words) {
  std::vector<std::byte> buffer(1 << 16);
  while (out.ours >= 0 || err.ours >= 0) {
    if (head.empty()) head = std::exchange(body, {});
    if (head.empty()) in.close_ours();
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return Talk::late;
    std::array<pollfd, 3> ready{
        {{in.ours, POLLOUT, 0}, {out.ours, POLLIN, 0}, {err.ours, POLLIN, 0}}};
    const int count =
        ::poll(ready.data(), ready.size(), static_cast<int>(std::min<long long>(left, 1000)));
    if (count < 0 && errno != EINTR) return Talk::broken;
    if (count <= 0) continue;
    if (ready[0].revents != 0) {
      const ssize_t n = ::send(in.ours, head.data(), head.size(), MSG_NOSIGNAL);
      if (n > 0) head = head.subspan(static_cast<std::size_t>(n));
      if (n < 0 && errno != EAGAIN && errno != EINTR) {
        head = body = {};  // it has stopped listening: what it says about that comes on err
      }
    }
    const auto take = [&](Channel& from, short revents) -> std::span<const std::byte> {
      if (from.ours < 0 || revents == 0) return {};
      const ssize_t n = ::read(from.ours, buffer.data(), buffer.size());
      if (n == 0 || (n < 0 && errno != EAGAIN && errno != EINTR)) from.close_ours();
      return std::span(buffer).first(n > 0 ? static_cast<std::size_t>(n) : 0);
    };
    const auto got = take(out, ready[1].revents);
    if (output.size() + got.size() > most_bytes) return Talk::too_much;
    output.insert(output.end(), got.begin(), got.end());
    for (const std::byte b : take(err, ready[2].revents)) words += static_cast<char>(b);
    if (words.size() > kLastWords) words.erase(0, words.size() - kLastWords);
  }
  return Talk::done;
}

/// One line for a Problem.
std::string last_words(std::string words) {
  while (!words.empty() && (words.back() == '\n' || words.back() == ' ')) words.pop_back();
  std::replace_if(
      words.begin(), words.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return words.empty() ? "It said nothing." : "It said: " + words;
}

std::string how_it_ended(int status) {
  if (WIFSIGNALED(status)) return "ended by signal " + std::to_string(WTERMSIG(status));
  return "ended with status " + std::to_string(WEXITSTATUS(status));
}

std::span<const std::byte> bytes_of(std::span<const std::uint8_t> body) {
  return std::as_bytes(body);
}

}  // namespace

Result<HelperOutput> run_helper(const std::filesystem::path& program, const std::string& head,
                                std::span<const std::uint8_t> body, double timeout_s,
                                std::size_t most_bytes) {
  const auto told = [&](std::string what, std::string remedy) {
    return problem(program.string(), std::move(what), std::move(remedy), 1);
  };
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(timeout_s));
  Channel in, out, err;
  if (!in.open_for_writing() || !out.open_for_reading() || !err.open_for_reading()) {
    return told(std::string("No pipe to the helper could be opened: ") + std::strerror(errno) + ".",
                "Raise the limit on open files, and restart the kiosk if this returns.");
  }
  pid_t pid = -1;
  if (const int error = start(program, in.theirs, out.theirs, err.theirs, pid)) {
    return told(std::string("The helper could not be started: ") + std::strerror(error) + ".",
                "It belongs beside the program onggi: build or install the kiosk again.");
  }
  Child child(pid);
  in.close_theirs();
  out.close_theirs();
  err.close_theirs();

  HelperOutput result;
  std::string words;
  const Talk talked = talk(in, out, err, std::as_bytes(std::span(head)), bytes_of(body), most_bytes,
                           deadline, result.out, words);
  if (talked == Talk::too_much) {
    return told("The helper wrote more than any such picture needs.",
                "Build the kiosk again, so that both come from the same version.");
  }
  if (talked == Talk::broken) {
    return told("The helper could not be listened to.", "Restart the kiosk if this returns.");
  }
  if (talked == Talk::late || !child.wait_until(deadline)) {
    child.kill_and_wait();
    return told("The helper had not ended after " +
                    std::to_string(static_cast<int>(timeout_s + 0.5)) + " s and was stopped. " +
                    last_words(words),
                "The machine may be overloaded or its disk failing: look at what else runs on it.");
  }
  if (child.status() != 0) {
    return told("The helper " + how_it_ended(child.status()) + ". " + last_words(words),
                "Check that its libraries are installed (bash kiosk/start does), and free memory.");
  }
  return result;
}

}  // namespace onggi::souvenir
