#pragma once

#include <string>

#include "kiosk/ground/cli/command.h"

namespace onggi::cli {

/// The manual page (section 1, man(7) macros, UTF-8) of `program`: every command below it, at any
/// depth, with its options, defaults and examples, as its --help has them. `version` as --version
/// prints it; `date` as "2026-11-22", for the foot. Hidden options stay out.
std::string man_page(const Command& program, const std::string& version, const std::string& date);

}  // namespace onggi::cli
