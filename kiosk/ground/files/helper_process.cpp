#include "kiosk/ground/files/helper_process.h"

#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

#include "kiosk/ground/files/child_process.h"

namespace onggi::files {
namespace {

using Clock = ChildProcess::Clock;

constexpr int kLook = 100;                // ms between two checks of its progress
constexpr std::size_t kLastWords = 2000;  // bytes of standard error in a Problem

enum class Talk { done, late, too_much, broken };

/// Tells a hung helper from one that waits for its turn on a busy machine, by its processor time.
class Patience {
 public:
  Patience(const ChildProcess& child, double seconds)
      : child_(child), seconds_(seconds), seen_at_(Clock::now()) {}

  bool over() {
    const double used = child_.processor_seconds();
    const auto now = Clock::now();
    if (used - seen_ > kStill * seconds_) {
      seen_ = used;
      seen_at_ = now;
    }
    return used > seconds_ || std::chrono::duration<double>(now - seen_at_).count() > seconds_;
  }

 private:
  // Share of the patience; less work than this counts as none.
  static constexpr double kStill = 1e-3;
  const ChildProcess& child_;
  double seconds_, seen_ = 0;
  Clock::time_point seen_at_;
};

/// Writes head and body, and reads out and err, until the helper has closed both.
Talk talk(Descriptor& in, Descriptor& out, Descriptor& err, std::span<const std::byte> head,
          std::span<const std::byte> body, std::size_t most_bytes, Patience& patience,
          std::vector<std::byte>& output, std::string& words) {
  std::vector<std::byte> buffer(1 << 16);
  while (out.open() || err.open()) {
    if (head.empty()) head = std::exchange(body, {});
    if (head.empty()) in.close();
    if (patience.over()) return Talk::late;
    std::array<pollfd, 3> ready{
        {{in.get(), POLLOUT, 0}, {out.get(), POLLIN, 0}, {err.get(), POLLIN, 0}}};
    const int count = ::poll(ready.data(), ready.size(), kLook);
    if (count < 0 && errno != EINTR) return Talk::broken;
    if (count <= 0) continue;
    if (ready[0].revents != 0) {
      const ssize_t n = ::send(in.get(), head.data(), head.size(), MSG_NOSIGNAL);
      if (n > 0) head = head.subspan(static_cast<std::size_t>(n));
      if (n < 0 && errno != EAGAIN && errno != EINTR) {
        head = body = {};  // it stopped reading; the reason comes on err
      }
    }
    const auto take = [&](Descriptor& from, short revents) -> std::span<const std::byte> {
      if (!from.open() || revents == 0) return {};
      const ssize_t n = ::read(from.get(), buffer.data(), buffer.size());
      if (n == 0 || (n < 0 && errno != EAGAIN && errno != EINTR)) from.close();
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
  return words.empty() ? "It printed nothing." : "It printed: " + words;
}

std::string how_it_ended(int status) {
  if (WIFSIGNALED(status)) return "ended by signal " + std::to_string(WTERMSIG(status));
  return "ended with status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

Result<std::vector<std::byte>> run_helper(const Helper& helper) {
  const auto told = [&](std::string what, std::string remedy) {
    return problem(helper.program, std::move(what), std::move(remedy), 1);
  };
  Channel in, out, err;
  if (!in.open_for_writing() || !out.open_for_reading() || !err.open_for_reading()) {
    return told(std::string("No pipe to the helper could be opened: ") + std::strerror(errno) + ".",
                "Raise the limit on open files, and restart the kiosk if this happens again.");
  }
  auto child = ChildProcess::start(helper.program, helper.arguments,
                                   {in.theirs.get(), out.theirs.get(), err.theirs.get()});
  if (!child) {
    return told(
        std::string("The helper could not be started: ") + std::strerror(child.error()) + ".",
        "It belongs beside the program onggi: build or install the kiosk again.");
  }
  for (Channel* channel : {&in, &out, &err}) channel->theirs.close();

  std::vector<std::byte> output;
  std::string words;
  Patience patience(*child, helper.timeout_s);
  const Talk talked = talk(in.ours, out.ours, err.ours, std::as_bytes(std::span(helper.head)),
                           std::as_bytes(helper.body), helper.most_bytes, patience, output, words);
  if (talked == Talk::too_much) {
    return told(std::string("The helper wrote a larger ") + helper.answer + " than it may.",
                "Build the kiosk again, so that both come from the same version.");
  }
  if (talked == Talk::broken) {
    return told("The helper's output could not be read.",
                "Restart the kiosk if this happens again.");
  }
  if (talked == Talk::late || !child->wait_until(Clock::now() + std::chrono::seconds(1))) {
    child->end(SIGKILL);
    return told("The helper did not finish within " +
                    std::to_string(static_cast<int>(helper.timeout_s + 0.5)) +
                    " s and was stopped. " + last_words(words),
                "The disk may be failing. Check the system log.");
  }
  const int status = child->status();
  if (status != 0 && !(WIFEXITED(status) && WEXITSTATUS(status) == helper.also_good)) {
    return told("The helper " + how_it_ended(child->status()) + ". " + last_words(words),
                "Install its libraries (bash kiosk/start does this), and free some memory.");
  }
  return output;
}

}  // namespace onggi::files
