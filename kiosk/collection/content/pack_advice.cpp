#include "kiosk/collection/content/pack_advice.h"

#include <algorithm>
#include <cctype>

#include "kiosk/collection/settings/visitor_text.h"

namespace onggi::content {
namespace {

using Table = toml::TomlReader::Table;
using settings::is_blank;
using settings::TextBound;

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

template <class Owner>
struct BoundedField {
  const char* key;
  std::string Owner::*text;
  TextBound bound;
};
constexpr BoundedField<Pack> kPackFields[] = {
    {"institution", &Pack::institution, settings::bounds::kInstitution},
    {"accession", &Pack::accession, settings::bounds::kAccession},
    {"source", &Pack::source, settings::bounds::kSource},
    {"credit", &Pack::credit, settings::bounds::kCredit},
    {"licence", &Pack::licence, settings::bounds::kLicence}};
constexpr BoundedField<Label> kLabelFields[] = {
    {"title", &Label::title, settings::bounds::kTitle},
    {"what", &Label::what, settings::bounds::kWhat},
    {"culture", &Label::culture, settings::bounds::kCulture},
    {"date", &Label::date, settings::bounds::kDate},
    {"made", &Label::made, settings::bounds::kMade},
    {"text", &Label::text, settings::bounds::kText},
    {"credit", &Label::credit, settings::bounds::kLabelCredit}};

/// Blank texts are asked for elsewhere.
template <class Owner, std::size_t kCount>
void fit(Table& table, const std::string& prefix, Owner& owner,
         const BoundedField<Owner> (&fields)[kCount]) {
  for (const BoundedField<Owner>& field : fields) {
    std::string& text = owner.*field.text;
    if (is_blank(text)) continue;
    if (const auto fault = settings::fault_of(text, prefix + field.key, field.bound)) {
      table.complain(field.key, fault->what, fault->remedy);
      text = settings::fitted(text, field.bound);
    }
  }
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

void fit_to_screens(Table root, Pack& pack) {
  fit(root, "", pack, kPackFields);
  auto labels = root.child("label");
  for (auto& [language, label] : pack.labels) {
    Table table = labels.child(language);
    fit(table, "label." + language + ".", label, kLabelFields);
  }
}

}  // namespace onggi::content
