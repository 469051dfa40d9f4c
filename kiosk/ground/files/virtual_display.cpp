#include "kiosk/ground/files/virtual_display.h"

#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace onggi::files {

namespace {

constexpr int kStartTimeoutMs = 10'000;

// Reads the display number that Xvfb writes when it is ready; empty if none came.
std::string read_display(const Descriptor& from) {
  std::string text;
  for (;;) {
    pollfd waiting{from.get(), POLLIN, 0};
    if (poll(&waiting, 1, kStartTimeoutMs) <= 0) return {};
    char c = 0;
    if (read(from.get(), &c, 1) != 1) return {};
    if (c == '\n') return text;
    text += c;
  }
}

}  // namespace

Result<std::unique_ptr<VirtualDisplay>> VirtualDisplay::ensure(int width, int height) {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"})
    if (const char* value = std::getenv(name); value != nullptr && *value != '\0')
      return std::unique_ptr<VirtualDisplay>();

  Channel said;
  if (!said.open_for_reading())
    return problem("Xvfb", "No pipe could be opened to it.", "Close other programs and try again.",
                   1);
  // setpriv (from util-linux, part of every Debian) lets the kernel end the server when this
  // process dies in any way. If it dies before setpriv is ready, the server finds its pipe closed
  // and ends itself.
  auto server =
      ChildProcess::start("setpriv",
                          {"--pdeathsig", "TERM", "Xvfb", "-displayfd", "1", "-screen", "0",
                           std::to_string(width) + "x" + std::to_string(height) + "x24",
                           "-nolisten", "tcp", "-noreset"},
                          {.out = said.theirs.get()});
  said.theirs.close();
  const std::string display = server ? read_display(said.ours) : std::string();
  if (display.empty())
    return problem("Xvfb", "There is no display, and a virtual one could not be started.",
                   "Install it (apt-get install xvfb), or set DISPLAY.", 1);
  setenv("DISPLAY", (":" + display).c_str(), 1);
  return std::unique_ptr<VirtualDisplay>(new VirtualDisplay(std::move(*server)));
}

VirtualDisplay::~VirtualDisplay() {
  // If SIGTERM arrives just as the X server falls asleep, it sleeps on for ten minutes.
  server_.end(SIGTERM, 2.0);
  unsetenv("DISPLAY");
}

}  // namespace onggi::files
