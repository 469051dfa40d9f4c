#include "kiosk/commands/command_line.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <exception>
#include <iostream>

namespace onggi::commands {

namespace {

CLI::Option* add_field(CLI::App& to, const Option& option, bool* field) {
  return to.add_flag(option.name, *field, option.help);
}
template <class Field>
CLI::Option* add_field(CLI::App& to, const Option& option, Field* field) {
  return to.add_option(option.name, *field, option.help);
}

void add_option(CLI::App& to, const Option& option) {
  CLI::Option* added =
      std::visit([&](auto* field) { return add_field(to, option, field); }, option.field);
  added->required(option.required);
  if (std::isfinite(option.most))
    added->check(CLI::Range(option.least, option.most));
  else if (option.least == 0.0)
    added->check(CLI::NonNegativeNumber);
  if (option.shows_default) added->capture_default_str();
  if (option.hidden) added->group("");
}

/// `chosen` becomes the innermost command that was named.
void describe(CLI::App& app, const Command& command, const Command*& chosen) {
  app.footer(command.examples);
  for (const Command& below : command.commands)
    describe(*app.add_subcommand(below.name, below.help), below, chosen);
  for (const Option& option : command.options) add_option(app, option);
  for (const Option& option : command.options)
    if (!option.excludes.empty())
      app.get_option(option.name)->excludes(app.get_option(option.excludes));
  if (!command.commands.empty()) app.require_subcommand(command.run ? 0 : 1, 1);
  app.callback([&app, &command, &chosen] {
    if (app.get_subcommands().empty()) chosen = &command;
  });
}

int run(const Command& command) {
  const Result<int> code = command.run();
  if (code) return *code;
  std::cerr << to_text(code.error()) << '\n';
  return code.error().exit_code;
}

}  // namespace

int run_command_line(const Command& program, const std::string& version, int argc,
                     const char* const* argv) {
  CLI::App app{program.help, program.name};
  app.set_version_flag("--version", program.name + " " + version);
  const Command* chosen = &program;
  describe(app, program, chosen);
  try {
    app.parse(argc, argv);
    return run(*chosen);
  } catch (const CLI::Success& asked) {
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    std::cerr << program.name << ": " << error.what() << "\n  See " << program.name
              << " --help, or " << program.name << " COMMAND --help, for what it takes.\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << program.name << ": " << error.what()
              << "\n  This is a fault of the program: please report it with the log above.\n";
    return 1;
  }
}

}  // namespace onggi::commands
