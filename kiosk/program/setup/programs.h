#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/program/setup/step.h"

namespace onggi::setup {

/// Runs `program`, with its words on this program's stream `out` (-1: unsaid) and its errors on the
/// error stream. Returns its exit status, or -1 if a signal ended it. Problem, exit 1: it cannot be
/// started, or does not end within `patience`.
Result<int> run_program(const std::string& program, const std::vector<std::string>& arguments,
                        std::chrono::seconds patience, int out = 2);

/// The same for systemctl, on a machine or an image of one.
Result<int> systemctl(const System& system, std::vector<std::string> arguments);

}  // namespace onggi::setup
