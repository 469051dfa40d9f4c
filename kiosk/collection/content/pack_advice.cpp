#include "kiosk/collection/content/pack_advice.h"

#include <algorithm>
#include <cctype>

namespace onggi::content {
namespace {

using Table = toml::TomlReader::Table;

/// True for placeholder words such as "not known", which no visitor should read.
bool is_no_answer(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text == kLicenceNotKnown || text == "todo" || text == "tbd" || text == "?";
}

/// Asks for `key` of `table`, called `name`, if it is missing, empty or a placeholder.
void ask(Table& table, const char* key, const std::string& name, const std::string& text,
         const std::string& remedy) {
  if (!table.has(key))
    table.complain("", name + " is missing.", remedy);
  else if (is_blank(text))
    table.complain(key, name + " is empty.", remedy);
  else if (is_no_answer(text))
    table.complain(key, name + " is \"" + text + "\", and visitors would see that.", remedy);
}

void ask_for_label(Table labels, const std::string& language, const Label& label) {
  Table table = labels.child(language);
  const std::string of = "label." + language + ".";
  if (is_no_answer(label.title)) ask(table, "title", of + "title", label.title, "Write its name.");
  ask(table, "culture", of + "culture", label.culture,
      "Say whose it was: culture = \"Korea, Joseon dynasty\".");
  ask(table, "date", of + "date", label.date,
      "Say when it was made, or that this is not known: date = \"18th century\", \"undated\".");
  ask(table, "made", of + "made", label.made,
      "Say in one sentence how it was made; if it was never thrown, say so.");
  ask(table, "text", of + "text", label.text,
      "Write at most " + std::to_string(kMostLabelWords) + " words about what visitors can see.");
  if (const int words = count_words(label.text); words > kMostLabelWords)
    table.complain("text",
                   "the label has " + std::to_string(words) + " words, but the limit is " +
                       std::to_string(kMostLabelWords) + ".",
                   "Shorten it to what visitors can see.");
}

}  // namespace

int count_words(const std::string& text) {
  int words = 0;
  bool inside = false;
  for (const char c : text) {
    const bool space = c == ' ' || c == '\n' || c == '\t' || c == '\r';
    if (!space && !inside) ++words;
    inside = !space;
  }
  return words;
}

bool is_blank(const std::string& text) { return count_words(text) == 0; }

void ask_for_the_rest(Table root, const Pack& pack, const std::vector<std::string>& languages) {
  if (pack.true_height == 0.0 && pack.true_diameter == 0.0 && pack.unit == 0.0)
    root.complain("", "the true size is missing, so the size of the vessel is not known.",
                  "Measure the real vessel, or look it up, and write: true_height_mm = 305.");
  ask(root, "institution", "institution", pack.institution,
      "Name the museum that has it: institution = \"National Museum of Korea, Seoul\".");
  ask(root, "source", "source", pack.source,
      "Say where the figures are published, or whose scan it is.");
  if (is_no_answer(pack.credit))
    ask(root, "credit", "credit", pack.credit, "Say whom to thank for the shape.");
  if (is_no_answer(pack.licence))
    ask(root, "licence", "the licence", pack.licence,
        "Ask the owner of the scan, and write it: licence = \"CC-BY-4.0\".");
  auto labels = root.child("label");
  for (const auto& [language, label] : pack.labels) ask_for_label(labels, language, label);
  for (const std::string& language : languages)
    if (!pack.labels.contains(language))
      labels.complain("", "there is no label in the language \"" + language + "\".",
                      "Write [label." + language +
                          "] with title, culture, date, made and text, or [vessel.NAME] with them "
                          "in content/languages/" +
                          language + ".toml.");
  if (languages.empty() && pack.labels.empty())
    labels.complain("", "there is no label.",
                    "Write [label.en] with title, culture, date, made and text.");
}

}  // namespace onggi::content
