#pragma once

#include <string>

#include "kiosk/ground/cli/command.h"

namespace onggi::cli {

/// The manual page (section 1, man(7) macros, UTF-8) of `program`: all commands at every depth with
/// their options, defaults and examples, the same as in --help. `version` is what --version prints;
/// `date` is like "2026-11-22", for the foot. Hidden options are left out.
std::string man_page(const Command& program, const std::string& version, const std::string& date);

}  // namespace onggi::cli
