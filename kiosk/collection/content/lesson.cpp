#include "kiosk/collection/content/lesson.h"

#include <span>

#include "engine/base/nearest_name.h"
#include "kiosk/collection/content/content_fields.h"
#include "kiosk/collection/settings/list_file.h"
#include "kiosk/collection/settings/text_in.h"
#include "kiosk/collection/settings/visitor_text.h"
#include "kiosk/ground/fields/field_reader.h"
#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::content {

namespace {

using LessonTable = toml::TomlReader::Table;

template <class Choice>
void read_choice(LessonTable& step, const std::string& key, std::span<const std::string_view> names,
                 Choice& out) {
  step.require(key, "Write " + key + " = \"...\", one of " + joined(names) + ".");
  settings::read_one_of(step, key, key, names, out);
}

bool read_step_words(LessonTable& step, const std::vector<std::string>& languages,
                     const settings::Translations& translations, const std::string& id,
                     std::map<std::string, std::string>& out) {
  LessonTable words = step.child("words");
  for (const std::string& code : words.keys()) {
    std::string text;
    if (settings::read_visitor_text(words, code, "words." + code, settings::bounds::kStepWords,
                                    text))
      out[code] = std::move(text);
  }
  translations.put("lesson", id, "words", out);
  for (const std::string& code : languages)
    if (!out.contains(code) && !words.has(code))
      step.complain(
          words.present() ? "words" : "", "The step has no words in the language \"" + code + "\".",
          "Write words = { " + code + " = \"...\" }, one entry for each language, or [lesson." +
              id + "] in content/languages/" + code + ".toml.");
  words.finish();
  return !out.empty();
}

bool read_step(LessonTable& table, const std::vector<std::string>& languages,
               const settings::Translations& translations, LessonStep& step) {
  bool good = settings::read_id(table, step.id, "open");
  if (languages.empty()) table.require("words", "Write words = { en = \"Open it.\" }.");
  good = read_step_words(table, languages, translations, step.id, step.words) && good;
  read_choice(table, "hands", kHandsDrawn, step.hands);
  read_choice(table, "until", kDoneWhen, step.until);
  fields::read_number(table, fields::field_at(lesson_fields(), "step", "after"), step.after);
  table.finish();
  return good;
}

}  // namespace

const std::string& LessonStep::words_in(const std::string& language) const {
  return settings::text_in(words, language);
}

LessonRead read_lesson(const std::filesystem::path& file, const std::vector<std::string>& languages,
                       const settings::Translations& translations) {
  LessonRead read;
  toml::TomlReader reader(file);
  read.steps = settings::read_list<LessonStep>(
      reader, "step", kMostSteps, "Remove some: at most " + std::to_string(kMostSteps) + " steps.",
      [&](LessonTable& table, LessonStep& step) {
        return read_step(table, languages, translations, step);
      });
  read.problems = reader.problems();
  read.keys_checked = reader.keys_checked();
  return read;
}

}  // namespace onggi::content
