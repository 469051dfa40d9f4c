#pragma once

#include <csignal>

#include "kiosk/ground/cli/command_line.h"
#include "kiosk/ground/files/memory.h"

namespace onggi::pages {

/// Runs `program`, as main() of a program of this folder. Same set-up as onggi's, so that what a
/// page shows is what the kiosk does. Returns the exit code.
inline int run_page_program(const cli::Command& program, int argc, const char* const* argv) {
  files::keep_heap_small();
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  return cli::run_command_line(program, "tests/pages", argc, argv);
}

}  // namespace onggi::pages
