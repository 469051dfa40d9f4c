#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <sstream>
#include <string>

#include "engine/base/plain_text.h"
#include "kiosk/exhibit/composition/check_exhibit.h"
#include "kiosk/exhibit/composition/check_json.h"
#include "kiosk/exhibit/editing/file_fields.h"
#include "kiosk/ground/fields/field_json.h"
#include "kiosk/program/commands/commands.h"

namespace onggi::commands {

namespace {

struct CheckArguments {
  std::string path, config;
  bool all = false, fields = false;
  files::Output json{files::Output::Kind::json};
};

/// A whole exhibit shows so many problems of a kind, and counts the others.
constexpr int kShown = 3;

bool is_plain(const std::string& word) {
  return std::ranges::all_of(word, [](char c) { return (c | 0x20) >= 'a' && (c | 0x20) <= 'z'; });
}

/// What a problem says without its names, numbers and keys, so that a language without a label for
/// each of twelve vessels is one kind.
std::string kind_of(const Problem& problem) {
  std::istringstream in(problem.what);
  std::string kind;
  for (std::string word; in >> word;)
    if (is_plain(word.substr(0, word.find_last_not_of(".,:;") + 1))) kind += word + " ";
  return kind;
}

/// Prints the problems. Only the first few of a kind, if there are more than one fewer would save.
void print_problems(const exhibit::CheckReport& report, bool all) {
  std::map<std::string, int> kinds, shown;
  for (const Problem& p : report.problems) ++kinds[kind_of(p)];
  for (const Problem& p : report.problems) {
    const std::string kind = kind_of(p);
    const int more = kinds[kind] - kShown;
    if (all || more <= 1 || ++shown[kind] <= kShown) std::cerr << to_text(p) << '\n';
    if (!all && more > 1 && shown[kind] == kShown)
      std::cerr << "  And " << more << " more like these. onggi check --all lists them.\n";
  }
}

/// Prints what was read and found.
void print_report(const exhibit::CheckReport& report, bool all) {
  if (all)
    for (const auto& file : report.files)
      std::cout << "checked " << terminal::plain(file.string()) << '\n';
  for (const Problem& note : report.notes) std::cout << to_text(note) << '\n';
  std::cout << std::flush;
  print_problems(report, all || !report.whole);
  std::cout << report.summary() << '\n';
}

/// Every key of every kind of file; nothing is checked.
Result<int> show_fields(const files::Output& json) {
  files::Json lists = files::Json::list();
  for (const fields::FieldList* list : editing::field_lists()) lists.push_back(json_of(*list));
  if (auto put = json.write(lists.text() + "\n"); !put) return tl::unexpected(put.error());
  if (json.wanted() && json.to_stdout()) return 0;
  for (const fields::FieldList* list : editing::field_lists()) std::cout << text_of(*list);
  return 0;
}

Result<int> check(const CheckArguments& arguments) {
  if (arguments.fields) return show_fields(arguments.json);
  const auto report = exhibit::check_path(arguments.path, arguments.config);
  if (!report) return tl::unexpected(report.error());
  // Written before anything is printed, so that a fault of the disk comes first.
  if (auto put = arguments.json.write(json_of(*report).text() + "\n"); !put)
    return tl::unexpected(put.error());
  if (!arguments.json.wanted() || !arguments.json.to_stdout()) print_report(*report, arguments.all);
  return report->problems.empty() ? 0 : 2;
}

}  // namespace

cli::Command check_command() {
  const auto a = std::make_shared<CheckArguments>();
  return {.name = "check",
          .help = "Find every problem of an exhibit, a shelf, a vessel or a drawing",
          .examples =
              "Example: onggi check config/exhibit.toml\n"
              "         onggi check --json -\n"
              "         onggi check --fields\n"
              "The last line says whether all is good. Of many problems of a kind it shows three.",
          .options = {{"path", &a->path,
                       "An exhibit's, scene's, drawing's or language's TOML, a vessel, or a shelf "
                       "[the exhibit]"},
                      {"--config", &a->config,
                       "The exhibit's TOML [the one in the current folder, else the program's]"},
                      {"--all", &a->all, "List every problem, and every file that was checked"},
                      {"--json", &a->json,
                       "Write every problem as JSON, with file, line and column (- for standard "
                       "output)"},
                      {.name = "--fields",
                       .field = &a->fields,
                       .help = "Show every key with what it may be, and check nothing; with --json "
                               "as JSON",
                       .excludes = "path"}},
          .run = [a] { return check(*a); }};
}

}  // namespace onggi::commands
