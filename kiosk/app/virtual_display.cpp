#include "kiosk/app/virtual_display.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace onggi::app {

namespace {

constexpr int kStartTimeoutMs = 10'000;

// The number that Xvfb writes to the pipe once it is ready to be connected to; empty if none came.
std::string read_display(int fd) {
  std::string text;
  for (;;) {
    pollfd waiting{fd, POLLIN, 0};
    if (poll(&waiting, 1, kStartTimeoutMs) <= 0) return {};
    char c = 0;
    if (read(fd, &c, 1) != 1) return {};
    if (c == '\n') return text;
    text += c;
  }
}

}  // namespace

Result<std::unique_ptr<VirtualDisplay>> VirtualDisplay::ensure(int width, int height) {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"})
    if (const char* value = std::getenv(name); value != nullptr && *value != '\0')
      return std::unique_ptr<VirtualDisplay>();

  int pipe_fds[2];
  if (pipe2(pipe_fds, O_CLOEXEC) != 0)
    return problem("Xvfb", "No pipe could be opened to it.", "Close other programs and try again.",
                   1);
  const std::string screen = std::to_string(width) + "x" + std::to_string(height) + "x24";
  const std::string fd_text = std::to_string(pipe_fds[1]);
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid == 0) {
    // Only async-signal-safe calls between fork and exec.
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) _exit(127);
    fcntl(pipe_fds[1], F_SETFD, 0);
    const int null = open("/dev/null", O_RDWR);
    dup2(null, 1);
    dup2(null, 2);
    execlp("Xvfb", "Xvfb", "-displayfd", fd_text.c_str(), "-screen", "0", screen.c_str(),
           "-nolisten", "tcp", "-noreset", static_cast<char*>(nullptr));
    _exit(127);
  }
  close(pipe_fds[1]);
  const std::string display = pid > 0 ? read_display(pipe_fds[0]) : std::string();
  close(pipe_fds[0]);
  if (display.empty()) {
    if (pid > 0) {
      kill(pid, SIGKILL);
      waitpid(pid, nullptr, 0);
    }
    return problem("Xvfb", "There is no display, and a virtual one could not be started.",
                   "Install it (apt-get install xvfb), or set DISPLAY.", 1);
  }
  setenv("DISPLAY", (":" + display).c_str(), 1);
  return std::unique_ptr<VirtualDisplay>(new VirtualDisplay(pid));
}

VirtualDisplay::~VirtualDisplay() {
  kill(pid_, SIGTERM);
  waitpid(pid_, nullptr, 0);
  unsetenv("DISPLAY");
}

}  // namespace onggi::app
