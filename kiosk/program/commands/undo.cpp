#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "engine/base/plain_text.h"
#include "kiosk/exhibit/editing/edit.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/ground/files/output.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/program/commands/commands.h"

namespace onggi::commands {

namespace {

struct UndoArguments {
  std::string config, id;
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

/// For programs, such as the staff's page: `words` tell what was done.
Result<int> answer(const UndoArguments& arguments, const Problem* refused,
                   const std::vector<std::string>& words) {
  using files::Json;
  Json out = Json::object({{"done", refused == nullptr}});
  if (refused != nullptr) {
    out["another_file"] = refused->exit_code == editing::kAnotherFile;
    out["where"] = refused->where;
    out["what"] = refused->what;
    out["remedy"] = refused->remedy;
  } else {
    out["words"] = Json::list_of(words);
  }
  if (auto put = arguments.json.write(out.text() + "\n"); !put) return tl::unexpected(put.error());
  return refused == nullptr ? 0 : 2;
}

Result<int> undo(const UndoArguments& arguments) {
  const auto exhibit = files::exhibit_file(arguments.config);
  if (!exhibit) return tl::unexpected(exhibit.error());
  if (arguments.list) return list(*exhibit);
  if (arguments.forget) {
    const auto forgotten = editing::forget_newest(*exhibit, arguments.id);
    if (arguments.json.wanted())
      return forgotten ? answer(arguments, nullptr, {changes::words_of(*forgotten)})
                       : answer(arguments, &forgotten.error(), {});
    if (!forgotten) return tl::unexpected(forgotten.error());
    std::cout << "Forgotten, and the file stays as it is: "
              << terminal::plain(forgotten->file.string()) << '\n'
              << indented(words_of(*forgotten)) << '\n';
    return 0;
  }
  const auto done = editing::undo(*exhibit, arguments.id);
  if (arguments.json.wanted()) {
    std::vector<std::string> words;
    if (done)
      for (const changes::ChangedValue& value : done->revision.values)
        words.push_back(changes::undo_words(value, done->revision.when));
    return answer(arguments, done ? nullptr : &done.error(), words);
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
                  {.name = "--if",
                   .field = &a->id,
                   .help = "Only if this change is still the newest (of a page)",
                   .hidden = true},
                  {"--config", &a->config,
                   "The exhibit's TOML [the one in the current folder, else the program's]"}},
      .run = [a] { return undo(*a); }};
}

}  // namespace onggi::commands
