#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/plain_text.h"
#include "kiosk/collection/changes/draft.h"
#include "kiosk/exhibit/editing/edit.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/ground/files/output.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/program/commands/commands.h"
#include "kiosk/program/commands/typed_changes.h"

namespace onggi::commands {

namespace {

using files::Json;

struct SetArguments {
  std::string file, without, tag;
  files::Output json{files::Output::Kind::json};
  std::vector<std::string> words;
};

Result<std::vector<changes::Change>> changes_of(const SetArguments& arguments) {
  if (arguments.words.empty() && arguments.without.empty())
    return problem(
        "onggi set", "No key is named.",
        "Name a key and its value: onggi set " + arguments.file + " idle.warn_after 90.");
  return typed_changes(arguments.words, arguments.without, "onggi set");
}

/// Without what is for somebody at a terminal.
std::string for_a_page(const std::string& remedy) {
  const std::string sudo = "Write sudo before the command. Or: ";
  return remedy.starts_with(sudo) ? remedy.substr(sudo.size()) : remedy;
}

/// For programs, such as the staff's page.
Result<int> answer(const SetArguments& arguments, const Result<editing::Edited>& done) {
  Json out = Json::object({{"done", done.has_value()}});
  if (done) {
    Json changes = Json::list();
    for (const changes::ChangedValue& value : done->revision.values)
      changes.push_back(Json::object({{"key", value.key}, {"was", value.was}, {"is", value.is}}));
    out["changes"] = changes;
    out["restarts_console"] = done->restarts_console;
    out["revision"] = done->revision.kept_in.stem().string();
  } else {
    out["another_file"] = done.error().exit_code == editing::kAnotherFile;
    out["where"] = done.error().where;
    out["what"] = done.error().what;
    out["remedy"] = for_a_page(done.error().remedy);
  }
  if (auto put = arguments.json.write(out.text() + "\n"); !put) return tl::unexpected(put.error());
  // Programs read why; whoever starts one tells a refusal from a crash.
  return done ? 0 : 2;
}

Result<int> set(const SetArguments& arguments) {
  const auto file = files::exhibit_file(arguments.file);
  if (!file) return tl::unexpected(file.error());
  const auto changes = changes_of(arguments);
  if (!changes) return tl::unexpected(changes.error());
  auto done = editing::set_values(*file, *changes, arguments.tag);
  if (arguments.json.wanted()) return answer(arguments, done);
  if (!done) {
    if (changes->size() > 1 && done.error().what.ends_with("is not a key of this file."))
      done.error().remedy += " A value with spaces stands in quotes: 'Museum of Clay'.";
    return tl::unexpected(done.error());
  }
  const std::string name = terminal::plain(file->string());
  if (done->revision.values.empty()) {
    std::cout << name << ": it is so already. Nothing was changed.\n";
    return 0;
  }
  for (const changes::ChangedValue& value : done->revision.values)
    std::cout << name << ": " << terminal::plain(changes::change_words(value)) << '\n';
  if (done->restarts_console) std::cout << "Start onggi-console again, so that it sees this.\n";
  std::cout << "An open kiosk takes it up when no visitor is there. To take it back: onggi undo\n";
  return 0;
}

}  // namespace

cli::Command set_command() {
  const auto a = std::make_shared<SetArguments>();
  return {.name = "set",
          .help = "Change one value of a settings file; everything else in it stays",
          .examples =
              "Example: onggi set config/exhibit.toml idle.warn_after 90\n"
              "         onggi set config/exhibit.toml credit 'Museum of Clay'\n"
              "         onggi set config/exhibit.toml languages en,ko,fr title.fr 'Un pot'\n"
              "         onggi set content/missions.toml mission.litre_jar.on true\n"
              "         onggi set --without hours.monday config/exhibit.toml\n"
              "The result is checked first, as by onggi check, and a fault changes nothing.",
          .options = {{.name = "file",
                       .field = &a->file,
                       .help = "The file, or the folder of an exhibit.toml",
                       .required = true},
                      {.name = "KEY VALUE ...",
                       .field = &a->words,
                       .help = "the key with its tables (idle.warn_after; an element of a list by "
                               "its id or number: step.open.after), and its value; more keys and "
                               "values are set in the same step"},
                      {.name = "--without",
                       .field = &a->without,
                       .help = "Take these keys out of the file, so that their defaults hold; "
                               "commas between them"},
                      {.name = "--if",
                       .field = &a->tag,
                       .help = "Only if the file is still the one with this tag (of a page)",
                       .hidden = true},
                      {.name = "--json",
                       .field = &a->json,
                       .help = "Tell what was done as JSON, for programs; - : standard output"}},
          .run = [a] { return set(*a); }};
}

}  // namespace onggi::commands
