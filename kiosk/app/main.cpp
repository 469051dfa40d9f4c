#include <csignal>

#include "kiosk/cli/command_line.h"
#include "kiosk/commands/commands.h"
#include "kiosk/device/last_word.h"
#include "kiosk/files/memory.h"

int main(int argc, char** argv) {
  onggi::files::keep_heap_small();
  onggi::device::end_forces_on_terminate();
  // A helper that dies while we write to it, or a file that may not grow, is an error to report and
  // not a reason to end.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  return onggi::cli::run_command_line(onggi::commands::onggi_command(), ONGGI_VERSION, argc, argv);
}
