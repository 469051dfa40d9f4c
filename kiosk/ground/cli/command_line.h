#pragma once

#include <string>

#include "kiosk/ground/cli/command.h"

namespace onggi::cli {

/// Reads the command line as `program` describes it and runs the named command, or the program's
/// own. Returns the exit code: 0 success, 1 a fault of the program or the machine, 2 a mistake in
/// the input. Answers --help and --version, and also --manual DAY, which the help does not list: it
/// prints the manual page (man_page.h) for the package. Prints Problems to standard error.
int run_command_line(const Command& program, const std::string& version, int argc,
                     const char* const* argv);

}  // namespace onggi::cli
