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

/// One option ("--json", "-o,--out"), flag (its field is a bool) or positional ("file") of a
/// command, and the field that it fills. The caller keeps the field alive. An Output is checked
/// before the command runs, and it adds the option --force to the command.
struct Option {
  /// The last: every word that no other option takes, as it was typed, one at the end of a command.
  using Field = std::variant<std::string*, bool*, int*, double*, std::uint64_t*, files::Output*,
                             std::vector<std::string>*>;
  std::string name;
  Field field;
  std::string help;
  bool required = false;
  double least = -std::numeric_limits<double>::infinity();  ///< Smallest number allowed; checked
                                                            ///< while parsing.
  double most = std::numeric_limits<double>::infinity();
  bool shows_default = false;  ///< The help shows the field's value at that moment.
  bool hidden = false;         ///< The help does not show it.
  std::string excludes{};  ///< The name of an option that cannot be used together with this one.
  std::string alone{};  ///< For a string: its value where the option stands without one. Empty: it
                        ///< needs one.
};

/// A command of the program as plain values, independent of the library that reads the command
/// line.
struct Command {
  std::string name;
  std::string help;      ///< One line.
  std::string examples;  ///< Shown below its help: at least one line that can be copied.
  std::vector<Option> options{};
  std::vector<Command> commands{};  ///< Subcommands: `onggi vessel` has make, inspect, import.
  /// Runs the command after its fields are filled, and returns the exit code. A returned Problem is
  /// printed and sets the exit code. Empty: the user must name one of `commands`.
  std::function<Result<int>()> run{};
};

}  // namespace onggi::cli
