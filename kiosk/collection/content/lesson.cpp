#include "kiosk/collection/content/lesson.h"

#include <algorithm>
#include <set>
#include <span>

#include "engine/base/nearest_name.h"
#include "kiosk/collection/settings/text_in.h"
#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::content {

namespace {

using LessonTable = toml::TomlReader::Table;

bool is_step_id(const std::string& text) {
  return !text.empty() && text.size() <= 40 && std::ranges::all_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

/// Letters as they are read, not bytes.
std::size_t letters(const std::string& utf8) {
  return static_cast<std::size_t>(
      std::ranges::count_if(utf8, [](char c) { return (c & 0xC0) != 0x80; }));
}

template <class Choice, std::size_t kCount>
void read_choice(LessonTable& step, const std::string& key,
                 const std::array<std::string_view, kCount>& names, Choice& out) {
  std::string all;
  for (const std::string_view name : names) all += (all.empty() ? "" : ", ") + std::string(name);
  step.require(key, "Write " + key + " = \"...\", one of " + all + ".");
  std::string text;
  if (!step.text(key, text)) return;
  const auto found = std::ranges::find(names, text);
  if (found != names.end()) {
    out = static_cast<Choice>(found - names.begin());
    return;
  }
  const std::string nearest = nearest_name(text, std::span<const std::string_view>(names));
  step.complain(
      key, "There is no " + key + " \"" + text + "\".",
      (nearest.empty() ? "" : "Did you mean \"" + nearest + "\"? ") + "Choose one of " + all + ".");
}

bool read_step_words(LessonTable& step, const std::vector<std::string>& languages,
                     std::map<std::string, std::string>& out) {
  LessonTable words = step.child("words");
  for (const std::string& code : words.keys()) {
    std::string text;
    if (!words.text(code, text)) continue;
    if (text.find_first_not_of(' ') == std::string::npos)
      words.complain(code, "words." + code + " is empty.", "Write a sentence, or leave it out.");
    else if (letters(text) > kMostStepLetters)
      words.complain(code,
                     "words." + code + " has " + std::to_string(letters(text)) +
                         " letters, but a step has room for " + std::to_string(kMostStepLetters) +
                         ".",
                     "Say it in one short sentence, or in two steps.");
    else
      out[code] = text;
  }
  for (const std::string& code : languages)
    if (!out.contains(code) && !words.has(code))
      step.complain(words.present() ? "words" : "",
                    "The step has no words in the language \"" + code + "\".",
                    "Write words = { " + code + " = \"...\" }, one entry for each language.");
  words.finish();
  return !out.empty();
}

bool read_step(LessonTable& table, const std::vector<std::string>& languages, LessonStep& step) {
  table.require("id", "Write a short name of letters, digits and _: id = \"open\".");
  bool good = table.text("id", step.id);
  if (good && !is_step_id(step.id)) {
    table.complain("id", "\"" + step.id + "\" is not a valid id.",
                   "Write 1 to 40 lower-case letters, digits and _: id = \"open\".");
    good = false;
  }
  if (languages.empty()) table.require("words", "Write words = { en = \"Open it.\" }.");
  good = read_step_words(table, languages, step.words) && good;
  read_choice(table, "hands", kHandsDrawn, step.hands);
  read_choice(table, "until", kDoneWhen, step.until);
  table.number("after", step.after, 3.0, 120.0, "s");
  table.finish();
  return good;
}

}  // namespace

const std::string& LessonStep::words_in(const std::string& language) const {
  return settings::text_in(words, language);
}

LessonRead read_lesson(const std::filesystem::path& file,
                       const std::vector<std::string>& languages) {
  LessonRead read;
  toml::TomlReader reader(file);
  auto root = reader.root();
  std::set<std::string> ids;
  for (LessonTable& table : root.children("step")) {
    LessonStep step;
    if (!read_step(table, languages, step)) continue;
    if (!ids.insert(step.id).second) {
      table.complain("id", "There are two steps \"" + step.id + "\".",
                     "Give the second another id.");
    } else if (read.steps.size() == kMostSteps) {
      table.complain("", "There are more than " + std::to_string(kMostSteps) + " steps.",
                     "Remove some: at most " + std::to_string(kMostSteps) + " steps.");
    } else {
      read.steps.push_back(std::move(step));
    }
  }
  root.finish();
  read.problems = reader.problems();
  read.keys_checked = reader.keys_checked();
  return read;
}

}  // namespace onggi::content
