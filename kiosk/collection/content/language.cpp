#include "kiosk/collection/content/language.h"

#include <algorithm>

#include "kiosk/collection/content/language_words.h"
#include "kiosk/collection/settings/visitor_text.h"
#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::content {

namespace {

/// The first fault in the pairing of braces in `text`; empty if there is none.
std::string brace_fault(const std::string& text) {
  bool open = false;
  for (const char c : text) {
    if (c == '{' && open) return "a { is inside another {";
    if (c == '}' && !open) return "a } has no { before it";
    if (c == '{') open = true;
    if (c == '}') open = false;
  }
  return open ? "a { has no } after it" : "";
}

/// Reads every text of `table` and of the tables in it: a.b = "x" and "a.b" = "x" are the same.
void read_texts(toml::TomlReader::Table table, const std::string& prefix,
                std::vector<WrittenText>& out) {
  for (const std::string& key : table.keys()) {
    if (table.has_table(key)) {
      read_texts(table.child(key), prefix + key + ".", out);
      continue;
    }
    std::string words;
    if (!table.text(key, words)) continue;
    const std::string full = prefix + key;
    if (settings::is_blank(words))
      table.complain(
          key, full + (words.empty() ? " is empty." : " has only characters that nobody can see."),
          "Write its words. In any language but English you may leave the key out.");
    if (const std::string fault = brace_fault(words); !fault.empty())
      table.complain(key, "in " + full + ", " + fault + ".",
                     "Write a placeholder as {name}, in one pair of braces.");
    out.push_back({full, std::move(words), table, key});
  }
  table.finish();
}

}  // namespace

LanguageRead check_language(const std::filesystem::path& file, const KnownIds& known) {
  LanguageRead read;
  toml::TomlReader reader(file);
  auto root = reader.root();
  auto text = root.child("text");
  root.require("code", "Write the language's code: code = \"ko\".");
  root.require("name", "Write the language's own name: name = \"한국어\".");
  root.text("code", read.language.code_);
  settings::read_visitor_text(root, "name", "name", settings::bounds::kLanguageName,
                              read.language.name_);
  root.boolean("right_to_left", read.language.right_to_left_);
  std::string decimal;
  if (root.text("decimal", decimal)) {
    if (decimal == "." || decimal == "," || decimal == "\u066B")
      read.language.decimal_ = decimal;
    else
      root.complain("decimal", "\"" + decimal + "\" is not a decimal separator.",
                    "Write decimal = \".\" or decimal = \",\".");
  }
  if (!read.language.code_.empty() && read.language.code_ != file.stem().string())
    root.complain("code",
                  "code is \"" + read.language.code_ + "\", but the file is called " +
                      file.filename().string() + ".",
                  "Rename the file to " + read.language.code_ + ".toml.");
  if (reader.ok() && !text.present())
    root.complain("", "the language has no words.", "Add a table [text] with key = \"words\".");
  std::vector<WrittenText> written;
  if (text.present()) read_texts(text, "", written);
  // A fault of one of the exhibit's things leaves the language's own words good.
  const std::vector<Problem> before = reader.problems();
  read_translation_tables(root, known);
  const std::vector<Problem> of_things = reader.problems_since(before);
  root.finish();
  read.problems = reader.problems();
  std::erase_if(read.problems, [&](const Problem& problem) {
    return std::ranges::any_of(of_things, [&](const Problem& thing) {
      return thing.where == problem.where && thing.what == problem.what;
    });
  });
  if (text.present()) compare_with_english(text, written);
  if (!read.language.code_.starts_with("en")) ask_for_translation(text, written);
  read.advice = reader.problems_since(read.problems);
  for (WrittenText& one : written) read.language.texts_[one.key] = std::move(one.words);
  read.keys_checked = reader.keys_checked();
  return read;
}

Result<Language> Language::read(const std::filesystem::path& file) {
  LanguageRead read = check_language(file);
  if (!read.problems.empty()) return tl::unexpected<Problem>(read.problems.front());
  return read.language;
}

std::string Language::say(const std::string& key,
                          const std::map<std::string, std::string>& places) const {
  const auto found = texts_.find(key);
  const std::string* const words = found != texts_.end() ? &found->second : english_text(key);
  if (words == nullptr) return "[" + key + "]";
  const std::string& text = *words;
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t close = text[i] == '{' ? text.find('}', i) : std::string::npos;
    if (close == std::string::npos) {
      out += text[i];
      continue;
    }
    // A placeholder without a value stays visible, so that a test or a reader notices it.
    const auto place = places.find(text.substr(i + 1, close - i - 1));
    if (place == places.end())
      out += text.substr(i, close - i + 1);
    else
      out += place->first == "part" ? say("part." + place->second) : place->second;
    i = close;
  }
  return out;
}

bool Language::has(const std::string& key) const { return texts_.count(key) != 0; }

std::vector<std::string> Language::places(const std::string& key) const {
  const auto found = texts_.find(key);
  return found == texts_.end() ? std::vector<std::string>{} : places_in(found->second);
}

std::vector<std::string> Language::keys() const {
  std::vector<std::string> out;
  for (const auto& [key, text] : texts_) out.push_back(key);
  return out;
}

}  // namespace onggi::content
