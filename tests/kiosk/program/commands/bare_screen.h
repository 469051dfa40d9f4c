#pragma once

#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "kiosk/ground/files/child_process.h"
#include "tests/kiosk/program/commands/program.h"

namespace onggi::commands {

/// An Xorg as a kiosk has it, without desktop or window manager: one monitor whose mode RandR sets,
/// and a touch screen whose fingers come over a socket.
class BareScreen {
 public:
  /// Null where Xorg, its dummy screen or its rights are missing.
  static std::unique_ptr<BareScreen> start() {
    std::unique_ptr<BareScreen> screen(new BareScreen);
    return screen->begin() ? std::move(screen) : nullptr;
  }
  ~BareScreen() {
    if (glass_ >= 0) close(glass_);
    if (server_) server_->end(SIGTERM);
  }
  BareScreen(const BareScreen&) = delete;
  BareScreen& operator=(const BareScreen&) = delete;

  const std::string& display() const { return display_; }
  bool xrandr(const std::string& arguments) const {
    return text("xrandr " + arguments + " && echo done").find("done") != std::string::npos;
  }
  /// What `command` says of this display.
  std::string text(const std::string& command) const {
    const std::string file = (folder_ / "said").string();
    const int status = std::system(
        ("DISPLAY=" + display_ + " sh -c '" + command + "' >" + file + " 2>&1").c_str());
    return status < 0 ? std::string() : content(file);
  }
  /// "WIDTHxHEIGHT+X+Y" of the kiosk's window; "" while there is none.
  std::string window() const {
    const std::string all = text("xwininfo -root -tree");
    const auto at = all.find("\"Onggi\": (");
    const auto from = at == std::string::npos ? at : all.find(")", at);
    if (from == std::string::npos) return {};
    const auto begin = all.find_first_not_of(' ', from + 1);
    return all.substr(begin, all.find(' ', begin) - begin);
  }
  /// Waits for the window to be so, `seconds` at most.
  bool window_becomes(const std::string& wanted, double seconds) const {
    const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (window() != wanted) {
      if (std::chrono::steady_clock::now() > until) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return true;
  }
  /// One of several fingers on the glass, in shares of it from the top left.
  void put(std::uint32_t finger, double x, double y) { say_touch(finger, 18, x, y); }
  void move(std::uint32_t finger, double x, double y) { say_touch(finger, 19, x, y); }
  void lift(std::uint32_t finger, double x, double y) { say_touch(finger, 20, x, y); }
  /// A finger touches the glass, in shares of it from the top left, and lifts. Gives where X saw
  /// it, pixels of the whole screen.
  std::pair<int, int> touch(double x, double y) {
    ++finger_;
    say_touch(finger_, 18, x, y);
    say_touch(finger_, 19, x, y + 0.001);  // the pointer follows a touch that moves
    say(1, "");
    listen();
    const std::string where = text("xdotool getmouselocation");
    say_touch(finger_, 20, x, y);
    say(1, "");
    listen();
    std::pair<int, int> at{-1, -1};
    std::sscanf(where.c_str(), "x:%d y:%d", &at.first, &at.second);
    return at;
  }

 private:
  BareScreen() = default;

  static constexpr const char* kConfiguration = R"(
Section "ServerLayout"
  Identifier "layout"
  Screen "screen"
  InputDevice "glass"
EndSection
Section "ServerFlags"
  Option "AutoAddDevices" "false"
  Option "DontVTSwitch" "true"
EndSection
Section "Device"
  Identifier "card"
  Driver "dummy"
  VideoRam 16384
EndSection
Section "Monitor"
  Identifier "monitor"
  HorizSync 5-1000
  VertRefresh 5-200
EndSection
Section "Screen"
  Identifier "screen"
  Device "card"
  Monitor "monitor"
  DefaultDepth 24
  SubSection "Display"
    Depth 24
    Modes "640x480" "800x600"
    Virtual 1280 960
  EndSubSection
EndSection
Section "InputDevice"
  Identifier "glass"
  Driver "inputtest"
  Option "DeviceType" "Touch"
  Option "TouchCount" "10"
)";

  bool begin() {
    const std::string socket = (folder_ / "glass").string(), file = (folder_ / "conf").string();
    std::ofstream(file) << kConfiguration << "  Option \"SocketPath\" \"" << socket
                        << "\"\nEndSection\n";
    files::Channel said;
    if (!said.open_for_reading()) return false;
    auto server = files::ChildProcess::start(
        "setpriv",
        {"--pdeathsig", "TERM", "Xorg", "-displayfd", "1", "-config", file, "-noreset", "-nolisten",
         "tcp", "-logfile", (folder_ / "log").string(), "-novtswitch", "-sharevts", "-s", "0"},
        {.out = said.theirs.get()});
    said.theirs.close();
    if (!server) return false;
    server_ = std::make_unique<files::ChildProcess>(std::move(*server));
    for (char c = 0; c != '\n';) {
      pollfd waiting{said.ours.get(), POLLIN, 0};
      if (poll(&waiting, 1, 10'000) <= 0 || read(said.ours.get(), &c, 1) != 1) return false;
      if (c != '\n') display_ += c;
    }
    display_ = ":" + display_;
    return reach_glass(socket);
  }

  bool reach_glass(const std::string& path) {
    glass_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_un name{};
    name.sun_family = AF_UNIX;
    std::strncpy(name.sun_path, path.c_str(), sizeof name.sun_path - 1);
    if (connect(glass_, reinterpret_cast<sockaddr*>(&name), sizeof name) != 0) return false;
    const std::uint16_t version[2] = {1, 1};
    say(0, {reinterpret_cast<const char*>(version), sizeof version});
    return listen();
  }

  /// Xorg's xf86-input-inputtest-protocol.h.
  void say(std::uint32_t type, const std::string& body) const {
    const std::uint32_t head[2] = {static_cast<std::uint32_t>(8 + body.size()), type};
    const std::string all = std::string(reinterpret_cast<const char*>(head), sizeof head) + body;
    if (write(glass_, all.data(), all.size()) != static_cast<ssize_t>(all.size()))
      std::perror("inputtest");
  }
  void say_touch(std::uint32_t finger, std::uint32_t kind, double x, double y) const {
    struct {
      std::uint32_t finger, kind, unaccelerated;
      std::array<std::uint8_t, 8> mask{3};
      std::uint32_t gap = 0;
      std::array<double, 128> values{};
    } body{finger, kind, 0};
    body.values[0] = 65535 * x;
    body.values[1] = 65535 * y;
    say(6, {reinterpret_cast<const char*>(&body), sizeof body});
  }
  bool listen() const {
    std::array<char, 64> answer{};
    pollfd waiting{glass_, POLLIN, 0};
    return poll(&waiting, 1, 5'000) > 0 && read(glass_, answer.data(), answer.size()) > 0;
  }

  ScratchFolder folder_;
  std::unique_ptr<files::ChildProcess> server_;
  std::string display_;
  int glass_ = -1;
  std::uint32_t finger_ = 100;  // beyond those of put()
};

/// `onggi run ARGUMENTS` on it, in a run of its own.
inline std::optional<files::ChildProcess> run_on(const BareScreen& screen,
                                                 const std::string& arguments,
                                                 const std::string& log) {
  auto kiosk = files::ChildProcess::start(
      "sh",
      {"-c", "export DISPLAY=" + screen.display() +
                 "; unset WAYLAND_DISPLAY; exec '" ONGGI_PROGRAM "' run " + arguments + " 2>'" +
                 log + "'"},
      {});
  if (!kiosk) return {};
  for (int n = 0; n < 600 && content(log).find("First picture") == std::string::npos; ++n)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  return std::move(*kiosk);
}

}  // namespace onggi::commands
