#pragma once

#include <poll.h>
#include <unistd.h>

#include <csignal>
#include <optional>
#include <string>
#include <utility>

#include "kiosk/ground/files/child_process.h"

namespace onggi::commands {

/// A kiosk's X server, which a test ends before the kiosk does.
class DoomedServer {
 public:
  DoomedServer() {
    files::Channel number;
    if (!number.open_for_reading()) return;
    auto server = files::ChildProcess::start(
        "Xvfb", {"-displayfd", "1", "-screen", "0", "640x480x24", "-nolisten", "tcp"},
        {.out = number.theirs.get()});
    number.theirs.close();
    if (!server) return;
    server_.emplace(std::move(*server));
    pollfd waiting{number.ours.get(), POLLIN, 0};
    char digit = 0;
    while (digit != '\n' && ::poll(&waiting, 1, 10'000) == 1 &&
           ::read(number.ours.get(), &digit, 1) == 1)
      if (digit != '\n') name_ += digit;
  }
  std::string name() const { return name_.empty() ? "" : ":" + name_; }
  void end() { server_->end(SIGKILL); }

 private:
  std::optional<files::ChildProcess> server_;
  std::string name_;
};

}  // namespace onggi::commands
