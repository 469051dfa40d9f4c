#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/ground/files/output.h"

namespace onggi::cli {

/// An option ("--json", "-o,--out"), a flag (its field is a bool) or a positional ("file") of a
/// command, and the field that it fills. Whoever describes it keeps the field alive. An Output is
/// checked before the command runs, and brings the option --force to it.
struct Option {
  using Field = std::variant<std::string*, bool*, int*, double*, std::uint64_t*, files::Output*>;
  std::string name;
  Field field;
  std::string help;
  bool required = false;
  double least = -std::numeric_limits<double>::infinity();  ///< Of a number; checked on parsing.
  double most = std::numeric_limits<double>::infinity();
  bool shows_default = false;  ///< The help shows what the field holds now.
  bool hidden = false;         ///< The help does not show it.
  std::string excludes{};      ///< The name of an option that cannot stand beside it.
};

/// A command of the program as plain values, whatever library reads the command line.
struct Command {
  std::string name;
  std::string help;      ///< One line.
  std::string examples;  ///< Below its help: at least one that can be copied.
  std::vector<Option> options{};
  std::vector<Command> commands{};  ///< Of `onggi vessel`: make, inspect, import.
  /// Does its work, once the fields are filled, and gives the exit code. What it returns as a
  /// Problem is printed, and its exit code is the program's. None: one of `commands` must be named.
  std::function<Result<int>()> run{};
};

}  // namespace onggi::cli
