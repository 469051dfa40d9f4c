#include <csignal>
#include <iostream>
#include <string>
#include <vector>

#include "kiosk/ground/cli/command_line.h"
#include "kiosk/ground/files/memory.h"
#include "kiosk/program/commands/commands.h"
#include "kiosk/program/commands/lab_program.h"
#include "kiosk/wheel/device/stop_forces_on_terminate.h"

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + (argc > 0 ? 1 : 0), argv + argc);
  if (const auto for_laboratory = onggi::commands::words_for_laboratory(words)) {
    const onggi::Problem stays = onggi::commands::become_laboratory(*for_laboratory);
    std::cerr << onggi::to_text(stays) << '\n';
    return stays.exit_code;
  }
  onggi::files::keep_heap_small();
  onggi::device::stop_forces_on_terminate();
  // If a helper dies while we write to it, or a file may not grow, report an error instead of
  // ending.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  return onggi::cli::run_command_line(onggi::commands::onggi_command(), ONGGI_VERSION, argc, argv);
}
