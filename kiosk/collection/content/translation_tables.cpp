#include "kiosk/collection/content/translation_tables.h"

#include <algorithm>
#include <string_view>

#include "engine/base/nearest_name.h"
#include "kiosk/collection/content/address.h"
#include "kiosk/collection/content/lesson.h"
#include "kiosk/collection/content/pack_advice.h"
#include "kiosk/collection/content/vessel.h"
#include "kiosk/collection/settings/mission_file.h"

namespace onggi::content {
namespace {

/// A text that a language's file may say of a thing.
struct TranslatedText {
  const char* kind;
  const char* key;
  /// What is wrong with it, a whole sentence; empty: nothing. Null: any text will do.
  std::string (*fault)(const std::string& text) = nullptr;
};

template <std::size_t most>
std::string too_many_letters(const std::string& text) {
  const auto letters =
      std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; });  // UTF-8
  if (letters <= static_cast<std::ptrdiff_t>(most)) return "";
  return "It has " + std::to_string(letters) + " letters, but there is room for only " +
         std::to_string(most) + ".";
}

std::string too_many_words(const std::string& text) {
  const int words = count_words(text);
  if (words <= kMostLabelWords) return "";
  return "It has " + std::to_string(words) + " words, but the limit is " +
         std::to_string(kMostLabelWords) + ".";
}

constexpr TranslatedText kTexts[] = {
    {"vessel", "title"},
    {"vessel", "culture"},
    {"vessel", "date"},
    {"vessel", "made"},
    {"vessel", "text", too_many_words},
    {"vessel", "credit"},
    {"vessel", "address", fault_of_address},
    {"glaze", "name"},
    {"glaze", "about"},
    {"lesson", "words", too_many_letters<kMostStepLetters>},
    {"mission", "title", too_many_letters<settings::kMostTitleLetters>},
    {"mission", "about", too_many_letters<settings::kMostAboutLetters>},
};

/// "vessel" is how a visitor's thing is called in its Problem.
std::string thing_of(const std::string& kind) {
  return kind == "lesson" ? "step of the lesson" : kind;
}

void read_thing(toml::TomlReader::Table table, const std::string& kind,
                settings::Translations::Texts& out) {
  for (const TranslatedText& one : kTexts) {
    std::string text;
    if (kind != one.kind || !table.text(one.key, text)) continue;
    std::string fault;
    if (is_blank(text))
      fault = std::string(one.key) + " is empty.";
    else if (one.fault != nullptr)
      fault = one.fault(text);
    if (fault.empty())
      out[one.key] = std::move(text);
    else
      table.complain(one.key, fault, "Write it anew, or remove it to show what there is already.");
  }
  table.finish();
}

/// True if the exhibit has `id`, or nobody knows; else notes the Problem.
bool is_known(toml::TomlReader::Table& kinds, const std::string& kind, const std::string& id,
              const KnownIds& known) {
  const auto ids = known.find(kind);
  if (ids == known.end() || std::ranges::find(ids->second, id) != ids->second.end()) return true;
  const std::string nearest = nearest_name(id, ids->second);
  kinds.complain(id, "This exhibit has no " + thing_of(kind) + " \"" + id + "\".",
                 nearest.empty() ? "Write the id of one that it has, or remove the table."
                                 : "Did you mean [" + kind + "." + nearest + "]?");
  return false;
}

}  // namespace

settings::Translations::Language read_translation_tables(toml::TomlReader::Table& root,
                                                         const KnownIds& known) {
  settings::Translations::Language out;
  std::string_view last;
  for (const TranslatedText& one : kTexts) {
    if (one.kind == last) continue;
    last = one.kind;
    const std::string kind = one.kind;
    toml::TomlReader::Table kinds = root.child(kind);
    for (const std::string& id : kinds.keys()) {
      settings::Translations::Texts texts;
      read_thing(kinds.child(id), kind, texts);
      if (is_known(kinds, kind, id, known) && !texts.empty()) out[kind][id] = std::move(texts);
    }
    kinds.finish();
  }
  return out;
}

settings::Translations read_translations(const std::filesystem::path& folder,
                                         const std::vector<std::string>& languages) {
  settings::Translations out;
  for (const std::string& code : languages) {
    toml::TomlReader reader(folder / (code + ".toml"));
    auto root = reader.root();
    if (auto said = read_translation_tables(root, {}); !said.empty())
      out.languages[code] = std::move(said);
  }
  return out;
}

void translate(Vessel& vessel, const settings::Translations& translations) {
  constexpr std::pair<const char*, std::string Label::*> kLabelParts[] = {
      {"title", &Label::title},    {"culture", &Label::culture}, {"date", &Label::date},
      {"made", &Label::made},      {"text", &Label::text},       {"credit", &Label::credit},
      {"address", &Label::address}};
  std::map<std::string, Label> labels = vessel.labels;
  for (const auto& [code, language] : translations.languages)
    for (const auto& [key, part] : kLabelParts)
      if (const auto* text = translations.find(code, "vessel", vessel.id, key))
        labels.try_emplace(code, vessel.label(code)).first->second.*part = *text;
  vessel.labels = std::move(labels);
}

}  // namespace onggi::content
