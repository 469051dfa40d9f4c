// onggi-manual: prints the manual page of `onggi`. The build runs it; nothing installs it.
#include <iostream>

#include "kiosk/cli/man_page.h"
#include "kiosk/commands/commands.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: onggi-manual VERSION DATE\n";
    return 2;
  }
  std::cout << onggi::cli::man_page(onggi::commands::onggi_command(), argv[1], argv[2]);
  return std::cout.good() ? 0 : 1;
}
