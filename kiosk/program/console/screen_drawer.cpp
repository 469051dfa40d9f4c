#include "kiosk/program/console/screen_drawer.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "kiosk/ground/files/child_process.h"
#include "kiosk/ground/files/descriptor.h"

namespace onggi::console {

namespace {

namespace fs = std::filesystem;
using files::ChildProcess;
using files::Descriptor;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostOfAScreen = 32u << 20;           // bytes of some pictures
constexpr auto kScreenPatience = std::chrono::minutes(10);  // 15 s on a quiet machine
constexpr int kAskEvery = 200;                              // ms

DrawnScreen failed(std::string what, std::string remedy) {
  DrawnScreen drawn;
  drawn.what = std::move(what);
  drawn.remedy = std::move(remedy);
  return drawn;
}

DrawnScreen cannot_begin(int error) {
  return failed(std::string("The drawing cannot begin: ") + std::strerror(error) + ".",
                "Try again; if it stays so, restart the machine.");
}

/// Each word with a zero behind it, and an empty one at the end.
std::string sent(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += word + '\0';
  return all + '\0';
}

bool send_all(int socket, const std::string& bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t n = ::send(socket, bytes.data() + at, bytes.size() - at, MSG_NOSIGNAL);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    at += static_cast<std::size_t>(n);
  }
  return true;
}

/// What the other side writes until it closes; nothing where it becomes unwanted, takes too long or
/// writes too much.
std::optional<std::string> heard(int socket, const std::function<bool()>& unwanted) {
  std::string all;
  std::vector<char> buffer(1u << 16);
  for (const auto last = Clock::now() + kScreenPatience; Clock::now() < last;) {
    if (unwanted()) return std::nullopt;
    pollfd ready{socket, POLLIN, 0};
    if (::poll(&ready, 1, kAskEvery) <= 0) continue;
    const ssize_t n = ::read(socket, buffer.data(), buffer.size());
    if (n < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (n <= 0) return all;
    all.append(buffer.data(), static_cast<std::size_t>(n));
    if (all.size() > kMostOfAScreen) return std::nullopt;
  }
  return std::nullopt;
}

std::string text_in(const nlohmann::json& head, const char* key) {
  return head.contains(key) && head[key].is_string() ? head[key].get<std::string>() : "";
}

std::size_t number_in(const nlohmann::json& one, const char* key) {
  const bool there = one.is_object() && one.contains(key) && one[key].is_number_unsigned();
  return there ? one[key].get<std::size_t>() : 0;
}

/// The line of JSON, then the pictures' bytes.
DrawnScreen read_screen(const std::string& said) {
  const DrawnScreen broken =
      failed("The screen could not be drawn.",
             "Try again, and look at Files. If it stays so: onggi screen attract, at the machine, "
             "says more.");
  const std::size_t line = said.find('\n');
  const auto head = nlohmann::json::parse(said.substr(0, line), nullptr, false);
  if (line == std::string::npos || !head.is_object()) return broken;
  if (std::string what = text_in(head, "what"); !what.empty())
    return failed(std::move(what), text_in(head, "remedy"));
  if (!head.contains("pictures") || !head["pictures"].is_array()) return broken;
  DrawnScreen drawn;
  std::size_t at = line + 1;
  for (const auto& one : head["pictures"]) {
    const std::size_t bytes = number_in(one, "bytes");
    if (bytes == 0 || bytes > said.size() - at) return broken;
    drawn.pictures.push_back({static_cast<int>(number_in(one, "width")),
                              static_cast<int>(number_in(one, "height")), said.substr(at, bytes)});
    at += bytes;
  }
  return drawn.pictures.empty() ? broken : drawn;
}

DrawnScreen drawn_over(int socket, const std::function<bool()>& unwanted) {
  const auto said = heard(socket, unwanted);
  if (said) return read_screen(*said);
  if (!unwanted()) return failed("The drawing took too long and was ended.", "Try again later.");
  DrawnScreen drawn;
  drawn.left = true;
  return drawn;
}

/// By the service, which starts one process for each connection.
DrawnScreen drawn_by_service(const fs::path& service, const std::vector<std::string>& words,
                             const std::function<bool()>& unwanted) {
  const Descriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_un to{};
  to.sun_family = AF_UNIX;
  const std::string& name = service.native();
  if (!socket.open() || name.size() >= sizeof to.sun_path) return cannot_begin(errno);
  name.copy(to.sun_path, name.size());
  if (::connect(socket.get(), reinterpret_cast<const sockaddr*>(&to), sizeof to) != 0)
    return failed(std::string("The service that draws screens does not answer: ") +
                      std::strerror(errno) + ".",
                  "Start it: sudo systemctl start onggi-screen.socket");
  if (!send_all(socket.get(), sent(words))) return cannot_begin(errno);
  return drawn_over(socket.get(), unwanted);
}

DrawnScreen drawn_by_child(const fs::path& onggi, const std::vector<std::string>& words,
                           const std::function<bool()>& unwanted) {
  int ends[2] = {-1, -1};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return cannot_begin(errno);
  const Descriptor ours(ends[0]);
  Descriptor theirs(ends[1]);
  std::vector<std::string> arguments{"screen", "--page"};
  arguments.insert(arguments.end(), words.begin(), words.end());
  auto child = ChildProcess::start(onggi, arguments, {theirs.get(), theirs.get(), -1});
  theirs.close();
  if (!child) return cannot_begin(child.error());
  DrawnScreen drawn = drawn_over(ours.get(), unwanted);
  // It removes what it has made.
  child->end(SIGTERM, 2.0);
  return drawn;
}

}  // namespace

struct ScreenDrawer::Shared {
  std::mutex mutex;  // guards:
  std::optional<DrawnScreen> drawn;
};

bool ScreenDrawer::begin(std::vector<std::string> words, std::function<bool()> unwanted) {
  if (shared_) return false;
  shared_ = std::make_shared<Shared>();
  std::thread([shared = shared_, onggi = onggi_, service = service_, words = std::move(words),
               unwanted = std::move(unwanted)] {
    DrawnScreen drawn = service.empty() ? drawn_by_child(onggi, words, unwanted)
                                        : drawn_by_service(service, words, unwanted);
    const std::lock_guard lock(shared->mutex);
    shared->drawn = std::move(drawn);
  }).detach();
  return true;
}

bool ScreenDrawer::under_way() const {
  if (!shared_) return false;
  const std::lock_guard lock(shared_->mutex);
  return !shared_->drawn;
}

std::optional<DrawnScreen> ScreenDrawer::take() {
  if (!shared_ || under_way()) return std::nullopt;
  auto drawn = std::move(shared_->drawn);
  shared_.reset();
  return drawn;
}

}  // namespace onggi::console
