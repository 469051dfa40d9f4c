#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <iostream>

#include "kiosk/app/commands/commands.h"
#include "kiosk/app/heap.h"
#include "kiosk/app/version.h"

int main(int argc, char** argv) {
  onggi::app::keep_heap_small();
  // A helper that dies while we write to it, or a file that may not grow, is an error to report and
  // not a reason to end.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);

  CLI::App app{"Onggi: throw pots on a virtual wheel, in a museum.", "onggi"};
  app.set_version_flag("--version", "onggi " + onggi::app::version());
  app.require_subcommand(0, 1);
  app.footer(
      "Example: onggi --window 1280x720\n"
      "Without a subcommand the exhibit opens, as with: onggi run\n"
      "Exit: 0 good, 1 the program's or the machine's fault, 2 the input's.");
  int exit_code = 0;
  onggi::app::add_run(app, exit_code);
  onggi::app::add_visit(app, exit_code);
  onggi::app::add_replay(app, exit_code);
  onggi::app::add_check(app, exit_code);
  onggi::app::add_vessel(app, exit_code);
  onggi::app::add_score(app, exit_code);
  onggi::app::add_soak(app, exit_code);
  onggi::app::add_lab(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    std::cerr << "onggi: " << error.what()
              << "\n  See onggi --help, or onggi COMMAND --help, for what it takes.\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "onggi: " << error.what()
              << "\n  This is a fault of the program: please report it with the log above.\n";
    return 1;
  }
  return exit_code;
}
