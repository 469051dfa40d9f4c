#include "kiosk/ground/cli/man_page.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace onggi::cli {

namespace {

/// Escapes text for man(7): typed hyphens and backslashes are escaped, and no line is read as a
/// request.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) out += "\\&";
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
  }
  return out;
}

bool is_positional(const Option& option) { return option.name.front() != '-'; }

/// "FILE" for an option that takes a value; a flag takes none.
std::string value_of(const Option& option) {
  struct Word {
    std::string operator()(std::string*) const { return "TEXT"; }
    std::string operator()(bool*) const { return ""; }
    std::string operator()(int*) const { return "N"; }
    std::string operator()(double*) const { return "NUMBER"; }
    std::string operator()(std::uint64_t*) const { return "N"; }
    std::string operator()(files::Output*) const { return "FILE"; }
    std::string operator()(std::vector<std::string>*) const { return "TEXT ..."; }
  };
  return std::visit(Word{}, option.field);
}

std::string default_of(const Option& option) {
  struct Text {
    std::string operator()(const std::string* text) const { return *text; }
    std::string operator()(const bool* flag) const { return *flag ? "true" : "false"; }
    std::string operator()(const files::Output* output) const { return output->where(); }
    std::string operator()(const std::vector<std::string>* words) const {
      return words->empty() ? "" : words->front();
    }
    std::string operator()(const int* n) const { return std::to_string(*n); }
    std::string operator()(const std::uint64_t* n) const { return std::to_string(*n); }
    std::string operator()(const double* number) const {
      std::ostringstream shortest;
      shortest << *number;
      return shortest.str();
    }
  };
  return std::visit(Text{}, option.field);
}

std::string capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

void put_option(std::ostream& out, const Option& option) {
  out << ".TP\n";
  if (is_positional(option)) {
    out << "\\fI" << escaped(capitals(option.name)) << "\\fR\n";
  } else {
    std::string names = option.name;
    for (std::size_t at = 0; (at = names.find(',', at)) != std::string::npos; at += 2)
      names.replace(at, 1, ", ");
    out << "\\fB" << escaped(names) << "\\fR";
    if (const std::string value = value_of(option); !value.empty())
      out << " \\fI" << value << "\\fR";
    out << '\n';
  }
  out << escaped(option.help) << (option.required ? " (required)" : "");
  if (option.shows_default) out << " [" << escaped(default_of(option)) << ']';
  out << '\n';
}

bool writes_files(const Command& command) {
  return std::any_of(command.options.begin(), command.options.end(), [](const Option& option) {
    return std::holds_alternative<files::Output*>(option.field);
  });
}

std::string synopsis(const std::string& path, const Command& command) {
  std::string line = "\\fB" + escaped(path) + "\\fR";
  for (const Option& option : command.options)
    if (is_positional(option) && !option.hidden) {
      const std::string name = "\\fI" + escaped(capitals(option.name)) + "\\fR";
      line += option.required ? " " + name : " [" + name + "]";
    }
  return line + " [\\fIOPTION\\fR]...";
}

void put_options(std::ostream& out, const Command& command) {
  for (const Option& option : command.options)
    if (!option.hidden) put_option(out, option);
  if (writes_files(command)) out << ".TP\n\\fB\\-\\-force\\fR\nOverwrite a file of another kind\n";
}

void put_examples(std::ostream& out, const Command& command) {
  if (command.examples.empty()) return;
  out << ".PP\n.nf\n" << escaped(command.examples) << "\n.fi\n";
}

void put_command(std::ostream& out, const std::string& path, const Command& command) {
  if (command.run) {
    out << ".SS " << synopsis(path, command) << '\n' << escaped(command.help) << ".\n";
    put_options(out, command);
    put_examples(out, command);
  }
  for (const Command& below : command.commands) put_command(out, path + " " + below.name, below);
}

}  // namespace

std::string man_page(const Command& program, const std::string& version, const std::string& date) {
  std::ostringstream out;
  out << ".TH " << capitals(program.name) << " 1 " << date << " \"" << program.name << ' '
      << version << "\" \"User Commands\"\n";
  out << ".SH NAME\n" << program.name << " \\- " << escaped(program.help) << '\n';
  out << ".SH SYNOPSIS\n.B " << program.name << "\n[\\fICOMMAND\\fR] [\\fIOPTION\\fR]...\n";
  out << ".SH DESCRIPTION\n"
      << escaped(
             "Opens an exhibit where visitors throw pots of virtual clay on a wheel. Other "
             "commands "
             "check, measure and prepare an exhibit.")
      << '\n';
  put_options(out, program);
  put_examples(out, program);
  out << ".SH COMMANDS\n";
  for (const Command& command : program.commands)
    put_command(out, program.name + " " + command.name, command);
  out << ".SH EXIT STATUS\n"
         ".TP\n0\nSuccess.\n.TP\n1\nA fault of the program or the machine.\n"
         ".TP\n2\nA mistake in the input: the program prints where, what and the remedy.\n";
  return out.str();
}

}  // namespace onggi::cli
