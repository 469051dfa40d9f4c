// onggi-manual: prints the manual page of `onggi` or of `onggi-lab`. The build runs it; nothing
// installs it.
#include <iostream>
#include <string_view>

#include "kiosk/ground/cli/man_page.h"
#include "kiosk/lab/commands/lab_commands.h"
#include "kiosk/program/commands/commands.h"

int main(int argc, char** argv) {
  const std::string_view program = argc == 4 ? argv[1] : "";
  if (program != "onggi" && program != "onggi-lab") {
    std::cerr << "usage: onggi-manual onggi|onggi-lab VERSION DATE\n";
    return 2;
  }
  const auto command =
      program == "onggi" ? onggi::commands::onggi_command() : onggi::laboratory::lab_command();
  std::cout << onggi::cli::man_page(command, argv[2], argv[3]);
  return std::cout.good() ? 0 : 1;
}
