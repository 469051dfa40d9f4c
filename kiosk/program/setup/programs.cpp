#include "kiosk/program/setup/programs.h"

#include <sys/wait.h>

#include <csignal>

#include "kiosk/ground/files/child_process.h"

namespace onggi::setup {

namespace {

// Systemctl waits for the units that it starts.
constexpr auto kPatience = std::chrono::seconds(60);

}  // namespace

Result<int> run_program(const std::string& program, const std::vector<std::string>& arguments,
                        std::chrono::seconds patience, int out) {
  auto child = files::ChildProcess::start(program, arguments, {-1, out, 2});
  if (!child)
    return problem(program, "It cannot be started.",
                   "Onggi is set up on systems with systemd, such as Debian 13.", 1);
  if (!child->wait_until(files::ChildProcess::Clock::now() + patience)) {
    child->end(SIGKILL);
    return problem(program,
                   "It did not end within " + std::to_string(patience.count()) + " seconds.",
                   "Look at: journalctl -b -u onggi -u onggi-display", 1);
  }
  return WIFEXITED(child->status()) ? WEXITSTATUS(child->status()) : -1;
}

Result<int> systemctl(const System& system, std::vector<std::string> arguments) {
  if (system.root != "/") arguments.insert(arguments.begin(), "--root=" + system.root.string());
  return run_program("systemctl", arguments, kPatience);
}

}  // namespace onggi::setup
