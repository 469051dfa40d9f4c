#include "kiosk/program/console/page_words.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "kiosk/ground/toml/toml_json.h"
#include "kiosk/ground/toml/toml_reader.h"
#include "kiosk/ground/toml/toml_text.h"
#include "kiosk/program/console/said.h"

namespace onggi::console {

namespace fs = std::filesystem;
using Parsed = nlohmann::json;

namespace {

constexpr const char* kAddress = "/words";

/// "ko", "pt-BR"
bool is_code(const std::string& name) {
  return name.size() >= 2 && name.size() <= 12 && std::ranges::all_of(name, [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-';
         });
}

/// Each is a text, or, where it counts something, a text for each of the language's plural forms.
bool are_words(const Parsed& table) {
  if (!table.is_object()) return false;
  for (const auto& [english, words] : table.items()) {
    if (words.is_string()) continue;
    const bool counts = english.find("{count}") != std::string::npos;
    if (!counts || !words.is_object() || !words.contains("other")) return false;
    for (const Parsed& form : words)
      if (!form.is_string()) return false;
  }
  return true;
}

Result<Parsed> language_in(const fs::path& file) {
  const auto text = toml::read_toml_text(file);
  if (!text) return tl::unexpected(text.error());
  const auto reader = toml::TomlReader::of_text(*text, file.string());
  if (!reader.ok()) return tl::unexpected(reader.problems().front());
  Parsed language = Parsed::parse(toml::json_of(*text).value_or("{}"), nullptr, false);
  if (!language["name"].is_string() || !language["right_to_left"].is_boolean() ||
      !are_words(language["page"]) || !are_words(language["editors"]))
    return problem(file.string(), "This is no language of the staff's page.",
                   "It has name, right_to_left, [page] and [editors], and texts in both.");
  return language;
}

}  // namespace

PageWords::PageWords(const fs::path& folder, std::vector<Problem>& remarks) {
  std::error_code gone;
  if (!fs::is_directory(folder, gone))
    remarks.push_back({folder.empty() ? "content/staff" : folder.string(),
                       "The staff's page speaks English alone: its other languages are not here.",
                       "Put this folder of the program back.", 1});
  Parsed names = Parsed::object();
  for (fs::directory_iterator it(folder, gone), end; !gone && it != end; it.increment(gone)) {
    if (it->path().extension() != ".toml" || !is_code(it->path().stem().string())) continue;
    auto language = language_in(it->path());
    if (!language) {
      remarks.push_back(language.error());
      continue;
    }
    const std::string code = it->path().stem().string(), at = std::string(kAddress) + '/' + code;
    names[code] = (*language)["name"];
    answers_[at + "/editors"] = Parsed{{"editors", std::move((*language)["editors"])}}.dump();
    language->erase("editors");
    answers_[at] = language->dump();
  }
  answers_[kAddress] = names.dump();
}

fs::path PageWords::folder_of(const fs::path& onggi_console) {
  std::error_code error;
  for (fs::path above = onggi_console.parent_path();; above = above.parent_path()) {
    if (fs::path found = above / "content/staff"; fs::is_directory(found, error)) return found;
    if (above == above.parent_path()) return {};
  }
}

std::optional<web::Answer> PageWords::to(const web::Ask& ask) const {
  const auto found = answers_.find(ask.target);
  if (found == answers_.end()) return std::nullopt;
  return console::json(ask, found->second);
}

}  // namespace onggi::console
