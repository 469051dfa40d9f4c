#include <iostream>
#include <memory>
#include <sstream>
#include <string>

#include "engine/base/plain_text.h"
#include "kiosk/exhibit/editing/edit.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/ground/files/output.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/program/commands/commands.h"

namespace onggi::commands {

namespace {

struct UndoArguments {
  std::string config;
  files::Output json{files::Output::Kind::json};
  bool list = false, forget = false;
};

/// Each line behind two spaces, without anything that a terminal would obey.
std::string indented(const std::string& words) {
  std::string out;
  std::istringstream in(words);
  for (std::string line; std::getline(in, line);)
    out += (out.empty() ? "  " : "\n  ") + terminal::plain(line);
  return out;
}

Result<int> list(const std::filesystem::path& exhibit) {
  const changes::Revisions revisions(exhibit);
  const auto all = revisions.read();
  if (all.empty()) std::cout << "Nothing was changed by onggi set, so there is nothing to undo.\n";
  int number = 0;
  for (const changes::Revision& revision : all)
    std::cout << ++number << ". " << terminal::plain(revision.when) << "  "
              << terminal::plain(revision.file.string()) << '\n'
              << indented(words_of(revision)) << '\n';
  return 0;
}

files::Json json_of(const Result<editing::Undone>& done) {
  using files::Json;
  if (!done)
    return Json::object({{"done", false},
                         {"where", done.error().where},
                         {"what", done.error().what},
                         {"remedy", done.error().remedy}});
  Json words = Json::list();
  for (const changes::ChangedValue& value : done->revision.values)
    words.push_back(changes::undo_words(value, done->revision.when));
  return Json::object({{"done", true},
                       {"file", done->revision.file.string()},
                       {"words", words},
                       {"kept_others", done->kept_others}});
}

Result<int> undo(const UndoArguments& arguments) {
  const auto exhibit = files::exhibit_file(arguments.config);
  if (!exhibit) return tl::unexpected(exhibit.error());
  if (arguments.list) return list(*exhibit);
  if (arguments.forget) {
    const auto forgotten = editing::forget_newest(*exhibit);
    if (!forgotten) return tl::unexpected(forgotten.error());
    std::cout << "Forgotten, and the file stays as it is: "
              << terminal::plain(forgotten->file.string()) << '\n'
              << indented(words_of(*forgotten)) << '\n';
    return 0;
  }
  const auto done = editing::undo(*exhibit);
  if (arguments.json.wanted()) {
    const auto report = json_of(done);
    if (auto put = arguments.json.write(report.text() + "\n"); !put)
      return tl::unexpected(put.error());
    return done ? 0 : 2;
  }
  if (!done) return tl::unexpected(done.error());
  for (const changes::ChangedValue& value : done->revision.values)
    std::cout << terminal::plain(done->revision.file.string()) << ": "
              << terminal::plain(changes::undo_words(value, done->revision.when)) << '\n';
  if (done->kept_others) std::cout << "What was changed by hand since then stays.\n";
  return 0;
}

}  // namespace

cli::Command undo_command() {
  const auto a = std::make_shared<UndoArguments>();
  return {
      .name = "undo",
      .help = "Take back the newest change of onggi set, or list the last twenty",
      .examples =
          "Example: onggi undo --list\n"
          "         onggi undo\n"
          "Said again, it takes back the change before. Changes made by hand stay.",
      .options = {{"--list", &a->list, "List the changes, the newest first, and change nothing"},
                  {.name = "--forget",
                   .field = &a->forget,
                   .help = "Forget the newest change, and leave its file as it is",
                   .excludes = "--list"},
                  {.name = "--json",
                   .field = &a->json,
                   .help = "Tell what was taken back as JSON, for programs; - : standard output",
                   .excludes = "--list"},
                  {"--config", &a->config,
                   "The exhibit's TOML [the one in the current folder, else the program's]"}},
      .run = [a] { return undo(*a); }};
}

}  // namespace onggi::commands
