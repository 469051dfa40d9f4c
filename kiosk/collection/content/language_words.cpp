#include "kiosk/collection/content/language_words.h"

#include <algorithm>
#include <iterator>
#include <map>

#include "engine/base/nearest_name.h"
#include "kiosk/collection/settings/visitor_text.h"

namespace onggi::content {
namespace {

using Texts = std::map<std::string, std::string>;

void gather(toml::TomlReader::Table table, const std::string& prefix, Texts& out) {
  for (const std::string& key : table.keys())
    if (table.has_table(key))
      gather(table.child(key), prefix + key + ".", out);
    else
      table.text(key, out[prefix + key]);
}

const Texts& english() {
  static const Texts all = [] {
    Texts out;
    auto reader = toml::TomlReader::of_text(kEnglishToml, "the program's English");
    gather(reader.root().child("text"), "", out);
    return out;
  }();
  return all;
}

std::string last_part(const std::string& key) { return key.substr(key.rfind('.') + 1); }

/// The missing key that `wrong` was probably meant to be; empty if none.
std::string meant_by(const std::string& wrong, const std::vector<std::string>& missing) {
  if (const std::string near = nearest_name(wrong, missing); !near.empty()) return near;
  std::vector<std::string> same;
  for (const std::string& key : missing)
    if (last_part(key) == last_part(wrong)) same.push_back(key);
  return same.size() == 1 ? same.front() : "";
}

std::string braced(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "{" : ", {") + name + "}";
  return out;
}

void compare_places(WrittenText& text, const std::string& wanted_words) {
  const auto wanted = places_in(wanted_words), there = places_in(text.words);
  std::vector<std::string> lacking, unknown;
  std::set_difference(wanted.begin(), wanted.end(), there.begin(), there.end(),
                      std::back_inserter(lacking));
  std::set_difference(there.begin(), there.end(), wanted.begin(), wanted.end(),
                      std::back_inserter(unknown));
  if (!unknown.empty())
    text.table.complain(
        text.name,
        text.key + " has " + braced(unknown) + ", but the program fills no such placeholder.",
        wanted.empty() ? "Remove the braces and the word inside them."
                       : "Its placeholders are " + braced(wanted) + ".");
  else if (!lacking.empty())
    text.table.complain(
        text.name, text.key + " lacks " + braced(lacking) + ".",
        "Put it where the program's number or name belongs. In English: \"" + wanted_words + "\".");
}

/// Texts that two languages may share by chance, such as "Pause" or "{stars} / 5".
bool is_short(const std::string& words) { return std::count(words.begin(), words.end(), ' ') < 2; }

/// Above this share of the longer texts, their English words are no accident.
constexpr double kMostTheSame = 0.1;

}  // namespace

const std::string* english_text(const std::string& key) {
  const auto found = english().find(key);
  return found == english().end() ? nullptr : &found->second;
}

std::vector<std::string> places_in(const std::string& words) {
  std::vector<std::string> out;
  for (std::size_t i = words.find('{'); i != std::string::npos; i = words.find('{', i + 1))
    if (const std::size_t close = words.find('}', i); close != std::string::npos)
      out.push_back(words.substr(i + 1, close - i - 1));
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

void compare_with_english(toml::TomlReader::Table text, std::vector<WrittenText>& written) {
  std::vector<std::string> missing;
  for (const auto& wanted : english())
    if (std::none_of(written.begin(), written.end(),
                     [&wanted](const WrittenText& one) { return one.key == wanted.first; }))
      missing.push_back(wanted.first);
  for (WrittenText& one : written) {
    const auto wanted = english().find(one.key);
    if (wanted != english().end()) {
      compare_places(one, wanted->second);
      const settings::TextBound bound = settings::bound_beside(wanted->second);
      const auto fault = settings::fault_of(one.words, one.key, bound);
      if (!fault || settings::is_blank(one.words)) continue;
      one.table.complain(one.name, fault->what, fault->remedy);
      one.words = settings::fitted(one.words, bound);
      continue;
    }
    const std::string meant = meant_by(one.key, missing);
    std::erase(missing, meant);
    one.table.complain(
        one.name, one.key + " is not a text of the program.",
        meant.empty() ? "Remove it." : "Did you mean " + meant + "? That key is missing.");
  }
  for (const std::string& key : missing) {
    const std::string section = key.substr(0, key.find('.'));
    auto place = text.has_table(section) ? text.child(section) : text;
    place.complain("", key + " is missing.",
                   "Write it below [text." + section + "]. In English: " +
                       key.substr(key.find('.') + 1) + " = \"" + english().at(key) + "\".");
  }
}

void ask_for_translation(toml::TomlReader::Table text, const std::vector<WrittenText>& written) {
  int longer = 0;
  std::vector<std::string> same;
  for (const WrittenText& one : written) {
    const std::string* const wanted = english_text(one.key);
    if (wanted == nullptr || is_short(*wanted)) continue;
    ++longer;
    if (one.words == *wanted) same.push_back(one.key);
  }
  if (static_cast<double>(same.size()) <= kMostTheSame * longer) return;
  text.complain("",
                std::to_string(same.size()) + " of " + std::to_string(longer) +
                    " longer texts are still in English: " + same.front() + ", for example.",
                "Translate them. A text that is left out is shown in English.");
}

}  // namespace onggi::content
