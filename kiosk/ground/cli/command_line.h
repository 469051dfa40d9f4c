#pragma once

#include <string>

#include "kiosk/ground/cli/command.h"

namespace onggi::cli {

/// Reads the command line as `program` describes it, runs the command that was named, else the
/// program's own, and gives the exit code: 0 good, 1 the program's or the machine's fault, 2 the
/// input's. --help and --version are answered here, and --manual DAY, which no help shows: the
/// manual page of the program (man_page.h), for its package. Prints Problems to standard error.
int run_command_line(const Command& program, const std::string& version, int argc,
                     const char* const* argv);

}  // namespace onggi::cli
