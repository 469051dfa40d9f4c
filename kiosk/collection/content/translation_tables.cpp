#include "kiosk/collection/content/translation_tables.h"

#include <string_view>

#include "engine/base/nearest_name.h"
#include "kiosk/collection/content/address.h"
#include "kiosk/collection/content/pack_advice.h"
#include "kiosk/collection/settings/visitor_text.h"

namespace onggi::content {
namespace {

namespace bounds = settings::bounds;

std::string too_many_words(const std::string& text) {
  const int words = count_words(text);
  if (words <= kMostLabelWords) return "";
  return "It has " + std::to_string(words) + " words, but the limit is " +
         std::to_string(kMostLabelWords) + ".";
}

/// A text that a language's file may say of a thing.
struct TranslatedText {
  const char* kind;
  const char* key;
  settings::TextBound most;
  /// What else is wrong with it, a whole sentence; empty: nothing. Null: nothing else can be.
  std::string (*fault)(const std::string& text) = nullptr;
};

constexpr TranslatedText kTexts[] = {
    {"vessel", "title", bounds::kTitle},
    {"vessel", "what", bounds::kWhat},
    {"vessel", "culture", bounds::kCulture},
    {"vessel", "date", bounds::kDate},
    {"vessel", "made", bounds::kMade},
    {"vessel", "text", bounds::kText, too_many_words},
    {"vessel", "credit", bounds::kLabelCredit},
    {"vessel", "address", bounds::kSource, fault_of_address},
    {"glaze", "name", bounds::kGlazeName},
    {"glaze", "about", bounds::kGlazeAbout},
    {"lesson", "words", bounds::kStepWords},
    {"mission", "title", bounds::kMissionTitle},
    {"mission", "about", bounds::kMissionAbout},
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
    std::string fault = one.fault != nullptr ? one.fault(text) : "";
    if (const auto other = settings::fault_of(text, one.key, one.most)) fault = other->what;
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
      {"title", &Label::title},     {"culture", &Label::culture}, {"date", &Label::date},
      {"made", &Label::made},       {"text", &Label::text},       {"credit", &Label::credit},
      {"address", &Label::address}, {"what", &Label::what}};
  std::map<std::string, Label> labels = vessel.labels;
  for (const auto& [code, language] : translations.languages)
    for (const auto& [key, part] : kLabelParts)
      if (const auto* text = translations.find(code, "vessel", vessel.id, key))
        labels.try_emplace(code, vessel.label(code)).first->second.*part = *text;
  vessel.labels = std::move(labels);
}

}  // namespace onggi::content
