#include "kiosk/ground/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <exception>
#include <iostream>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "engine/base/plain_text.h"
#include "kiosk/ground/cli/man_page.h"
#include "kiosk/ground/files/printed.h"

namespace onggi::cli {

namespace {

CLI::Option* add_field(CLI::App& to, const Option& option, bool* field) {
  return to.add_flag(option.name, *field, option.help);
}
/// A comparison with "nan" is always false, so a range check lets it pass.
std::string not_finite(const std::string& text) {
  double value = 0.0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool named = read.ec == std::errc() && !std::isfinite(value);
  return named || read.ec == std::errc::result_out_of_range ? text + " is not a finite number" : "";
}

CLI::Option* add_field(CLI::App& to, const Option& option, double* field) {
  return to.add_option(option.name, *field, option.help)->check(not_finite);
}
/// An empty word is most often a shell's unset variable. Taken for "not given", the command would
/// do something else than it was asked for.
std::string not_empty(const std::string& text) {
  return text.empty() ? "it is empty: name something, or leave the option out" : "";
}
std::string not_empty_where_required(const std::string& text) {
  return text.empty() ? "it is empty: name something" : "";
}
CLI::Option* add_field(CLI::App& to, const Option& option, files::Output* field) {
  return to.add_option(option.name, field->where(), option.help)
      ->check(option.required ? not_empty_where_required : not_empty);
}
CLI::Option* add_field(CLI::App& to, const Option& option, std::string* field) {
  CLI::Option* added = to.add_option(option.name, *field, option.help)
                           ->check(option.required ? not_empty_where_required : not_empty);
  if (!option.alone.empty()) added->expected(0, 1)->default_str(option.alone);
  return added;
}
/// CLI11 takes the nearest number that fits for one that is too large.
template <class Whole>
std::string not_whole(const std::string& text) {
  Whole value = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec == std::errc::result_out_of_range)
    return text + " is too large: write at most " +
           std::to_string(std::numeric_limits<Whole>::max());
  return read.ec != std::errc() || read.ptr != end ? "\"" + text + "\" is not a whole number" : "";
}
CLI::Option* add_field(CLI::App& to, const Option& option, int* field) {
  return to.add_option(option.name, *field, option.help)->check(not_whole<int>);
}
CLI::Option* add_field(CLI::App& to, const Option& option, std::uint64_t* field) {
  return to.add_option(option.name, *field, option.help)->check(not_whole<std::uint64_t>);
}
/// For numbers from 0 upwards. CLI11's own message has a number of 309 digits.
std::string below_zero(const std::string& text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec != std::errc() || read.ptr != end)
    return "\"" + text + "\" is not a number: write one of at least 0";
  return value < 0.0 ? text + " is below 0: write a number of at least 0" : "";
}
std::string written(double number) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}
/// CLI11's own message writes six digits after the point, and nothing for an empty word.
CLI::Validator between(double least, double most) {
  const std::string range = "from " + written(least) + " to " + written(most);
  return {[=](const std::string& text) {
            double value = 0.0;
            const char* const end = text.data() + text.size();
            const auto read = std::from_chars(text.data(), end, value);
            if (read.ec != std::errc() || read.ptr != end)
              return "\"" + text + "\" is not a number: write one " + range;
            return value >= least && value <= most
                       ? std::string()
                       : text + " is too much or too little: write a number " + range;
          },
          "in [" + written(least) + " - " + written(most) + "]"};
}
using Words = std::vector<std::string>;

/// The words behind all others, which a command takes as they are; null if it takes none.
Words* rest_of(const Command& command) {
  for (const Option& option : command.options)
    if (Words* const* rest = std::get_if<Words*>(&option.field)) return *rest;
  return nullptr;
}

void add_option(CLI::App& to, const Option& option) {
  // CLI11 would take "[a, b]" for two words, and "-5" for an option. It keeps what it does not know
  // as it is, so these words are that.
  if (std::holds_alternative<Words*>(option.field)) {
    to.allow_extras();
    to.description(to.get_description() + "\n\n" + option.name + ": " + option.help);
    return;
  }
  CLI::Option* added = std::visit(
      [&](auto* field) -> CLI::Option* {
        if constexpr (std::is_same_v<decltype(field), Words*>)
          return nullptr;
        else
          return add_field(to, option, field);
      },
      option.field);
  added->required(option.required);
  if (std::isfinite(option.most))
    added->check(between(option.least, option.most));
  else if (option.least == 0.0)
    added->check(below_zero);
  if (option.shows_default) added->capture_default_str();
  if (option.hidden) added->group("");
}

/// The outputs of a command, in the order of its options.
std::vector<files::Output*> outputs_of(const Command& command) {
  std::vector<files::Output*> outputs;
  for (const Option& option : command.options)
    if (files::Output* const* output = std::get_if<files::Output*>(&option.field))
      outputs.push_back(*output);
  return outputs;
}

/// Sets `chosen` to the innermost command that was named.
void describe(CLI::App& app, const Command& command, const Command*& chosen, bool& force) {
  app.footer(command.examples);
  for (const Command& below : command.commands)
    describe(*app.add_subcommand(below.name, below.help), below, chosen, force);
  for (const Option& option : command.options) add_option(app, option);
  for (const Option& option : command.options)
    if (!option.excludes.empty())
      app.get_option(option.name)->excludes(app.get_option(option.excludes));
  if (!outputs_of(command).empty())
    app.add_flag("--force", force, "Overwrite a file of another kind");
  if (!command.commands.empty()) app.require_subcommand(command.run ? 0 : 1, 1);
  app.callback([&app, &command, &chosen] {
    if (!app.get_subcommands().empty()) return;
    chosen = &command;
    if (Words* rest = rest_of(command)) *rest = app.remaining();
  });
}

/// Check outputs before the work starts: a report can take minutes, and an error should come first.
Result<void> check_outputs(const std::vector<files::Output*>& outputs, bool force) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (force) outputs[i]->force();
    if (auto good = outputs[i]->check(); !good) return good;
    for (std::size_t j = 0; j < i; ++j)
      if (outputs[i]->clashes_with(*outputs[j]))
        return problem(outputs[i]->where(),
                       "Two outputs have this name, so one would overwrite the other.",
                       "Choose another name for one of them.");
  }
  return {};
}

int told(const Problem& problem) {
  std::cerr << to_text(problem) << '\n';
  return problem.exit_code;
}

int run(const Command& command, bool force) {
  if (auto good = check_outputs(outputs_of(command), force); !good) return told(good.error());
  const Result<int> code = command.run();
  return code ? *code : told(code.error());
}

/// An option that stands before the command's name, which `chosen` would not see.
std::optional<Problem> too_early(const CLI::App& app, const Command& command, const Command& chosen,
                                 const std::string& path) {
  const auto below = app.get_subcommands();
  if (below.empty()) return {};
  const auto next = std::ranges::find(command.commands, below.front()->get_name(), &Command::name);
  if (const auto deeper = too_early(*below.front(), *next, chosen, path)) return deeper;
  for (const Option& option : command.options) {
    if (std::holds_alternative<Words*>(option.field)) continue;
    const CLI::Option* given = app.get_option(option.name);
    if (given->count() == 0) continue;
    const bool flag = std::holds_alternative<bool*>(option.field);
    const std::string words =
        terminal::plain(given->get_name() + (flag ? "" : " " + given->results().back()));
    const bool known = std::ranges::any_of(
        chosen.options, [&option](const Option& other) { return other.name == option.name; });
    return Problem{words, "It stands before the command " + next->name + ", which does not see it.",
                   known ? "Write it behind: " + path + " " + words
                         : "Leave it out: " + path + " has no " + given->get_name() + "."};
  }
  return {};
}

/// The words that chose `app`'s innermost command: "onggi vessel make".
std::string path_of(const CLI::App& app) {
  const auto below = app.get_subcommands();
  return app.get_name() + (below.empty() ? "" : " " + path_of(*below.front()));
}

int run_words(const Command& program, const std::string& version, int argc,
              const char* const* argv) {
  CLI::App app{program.help, program.name};
  app.set_version_flag("--version", program.name + " " + version);
  // Handle --manual like --version, before a command is required.
  app.add_option_function<std::string>("--manual",
                                       [&program, &version](const std::string& day) {
                                         std::string page = man_page(program, version, day);
                                         page.pop_back();  // the line end comes with the answer
                                         throw CLI::CallForVersion(page, 0);
                                       })
      ->group("");
  const Command* chosen = &program;
  bool force = false;
  describe(app, program, chosen, force);
  try {
    app.parse(argc, argv);
    if (const auto early = too_early(app, program, *chosen, path_of(app))) return told(*early);
    return run(*chosen, force);
  } catch (const CLI::Success& asked) {
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    // It repeats words of the command line, which may hold a terminal's commands.
    std::cerr << program.name << ": " << terminal::plain(error.what()) << "\n  See " << program.name
              << " --help, or " << program.name << " COMMAND --help, for the options.\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << program.name << ": " << terminal::plain(error.what())
              << "\n  This is a fault of the program: please report it with the log above.\n";
    return 1;
  }
}

}  // namespace

int run_command_line(const Command& program, const std::string& version, int argc,
                     const char* const* argv) {
  const int code = run_words(program, version, argc, argv);
  const auto printed = files::all_printed();
  return printed ? code : std::max(code, told(printed.error()));
}

}  // namespace onggi::cli
