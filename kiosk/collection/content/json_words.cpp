#include "kiosk/collection/content/json_words.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "kiosk/collection/content/address.h"

namespace onggi::content::json_words {

using nlohmann::json;

namespace {

constexpr std::size_t kLongest = 1000, kMostLanguages = 12;

bool is_language(const std::string& key) {
  return (key.size() == 2 || key.size() == 3) &&
         std::all_of(key.begin(), key.end(), [](char c) { return c >= 'a' && c <= 'z'; });
}

}  // namespace

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

std::string tidy(std::string text) {
  if (text.size() > kLongest) {
    std::size_t end = kLongest;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;
    text.resize(end);
  }
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  const auto first = text.find_first_not_of(' ');
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

const json* member(const json& object, std::string_view key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

const json& within(const json& object, std::string_view key) {
  static const json kNothing;
  const json* found = member(object, key);
  return found == nullptr ? kNothing : *found;
}

const json& list_of(const json& object, std::string_view key) {
  static const json kEmpty = json::array();
  const json& found = within(object, key);
  return found.is_array() ? found : kEmpty;
}

int index_in(const json& object, std::string_view key, int otherwise) {
  const json& value = within(object, key);
  return value.is_number_unsigned() && value.get<std::uint64_t>() < 1u << 30 ? value.get<int>()
                                                                             : otherwise;
}

std::string string_in(const json& object, std::string_view key) {
  const json& value = within(object, key);
  return value.is_string() ? value.get<std::string>() : std::string();
}

std::string words_of(const json& value, int depth) {
  if (depth > 8) return "";
  if (value.is_string()) return tidy(value.get<std::string>());
  if (value.is_array()) {
    std::string all;
    for (const json& entry : value) {
      const json* language = member(entry, "@language");
      const std::string one = words_of(entry, depth + 1);
      if (language != nullptr && language->is_string()) {
        // The list holds one text in several languages, not several texts.
        if (language->get<std::string>().rfind("en", 0) == 0) return one;
        if (all.empty()) all = one;
      } else if (!one.empty()) {
        all += (all.empty() ? "" : ", ") + one;
      }
    }
    return tidy(all);
  }
  for (const char* inside :
       {"@value", "@list", "@set", "rdf:Alt", "rdf:Seq", "rdf:Bag", "rdf:_1", "name", "foaf:name",
        "schema:name", "@id", "en", "EN", "none", "content"})
    if (const json* found = member(value, inside)) return words_of(*found, depth + 1);
  const auto all = by_language(value);
  return all.empty() ? "" : all.begin()->second;
}

std::string first_of(const json& object, std::initializer_list<const char*> keys) {
  if (!object.is_object()) return "";
  for (const char* key : keys)
    for (auto at = object.begin(); at != object.end(); ++at)
      if (lower(at.key()) == key)
        if (std::string words = words_of(at.value()); !words.empty()) return words;
  return "";
}

std::string page_of(const json& object, std::initializer_list<const char*> keys) {
  for (const char* key : keys)
    if (std::string page = first_of(object, {key}); fault_of_address(page).empty()) return page;
  return "";
}

std::map<std::string, std::string> by_language(const json& value) {
  std::map<std::string, std::string> out;
  if (!value.is_object()) return out;
  for (auto at = value.begin(); at != value.end() && out.size() < kMostLanguages; ++at) {
    const std::string language = lower(at.key());
    const bool text = at->is_string() || at->is_array();
    if (!text || !is_language(language)) continue;
    if (std::string words = words_of(*at, 7); !words.empty()) out[language] = std::move(words);
  }
  return out;
}

}  // namespace onggi::content::json_words
