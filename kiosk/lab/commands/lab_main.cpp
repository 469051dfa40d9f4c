#include <csignal>

#include "kiosk/ground/cli/command_line.h"
#include "kiosk/ground/files/memory.h"
#include "kiosk/lab/commands/lab_commands.h"
#include "kiosk/wheel/device/stop_forces_on_terminate.h"

// Same set-up as kiosk/program/commands/onggi_main.cpp, so that measurements match the kiosk.
int main(int argc, char** argv) {
  onggi::files::keep_heap_small();
  onggi::device::stop_forces_on_terminate();
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  return onggi::cli::run_command_line(onggi::laboratory::lab_command(), ONGGI_VERSION, argc, argv);
}
