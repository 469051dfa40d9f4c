#include "kiosk/keepsake/phone/phone_words.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <optional>
#include <system_error>

#include "kiosk/ground/toml/toml_reader.h"
#include "kiosk/keepsake/phone/page_files.h"

namespace fs = std::filesystem;

namespace onggi::phone {

namespace {

std::map<std::string, std::string> phone_texts(toml::TomlReader& reader) {
  std::map<std::string, std::string> texts;
  auto table = reader.root().child("text").child("phone");
  for (const std::string& key : table.keys())
    if (std::string text; table.text(key, text) && !text.empty()) texts[key] = text;
  return texts;
}

PhoneWords words_of(toml::TomlReader& reader) {
  PhoneWords words;
  auto root = reader.root();
  root.text("code", words.code);
  root.text("name", words.name);
  root.boolean("right_to_left", words.right_to_left);
  words.texts = phone_texts(reader);
  return words;
}

/// Reads the language of `file`; Problem if it cannot be used.
Result<PhoneWords> read_words(const fs::path& file, const PhoneWords& english) {
  toml::TomlReader reader(file);
  PhoneWords words = words_of(reader);
  if (!reader.problems().empty()) return tl::unexpected<Problem>(reader.problems().front());
  if (words.code != file.stem().string() || words.name.empty())
    return problem(file.string(),
                   "The language has no name, or its code differs from the file name.",
                   "Run onggi check for details.");
  for (const auto& [key, text] : english.texts)
    if (words.texts.count(key) == 0)
      return problem(
          file.string(),
          "phone." + key + " is missing, so phones do not get pages in " + words.name + ".",
          "Write it below [text.phone]. In English: " + key + " = \"" + text + "\".");
  return words;
}

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

PhoneLanguages::PhoneLanguages() {
  auto reader = toml::TomlReader::of_text(k_en_toml, "the program's English");
  all_.push_back(words_of(reader));
}

PhoneLanguages PhoneLanguages::read(const fs::path& folder, std::vector<Problem>& remarks) {
  PhoneLanguages languages;
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
    if (at->path().extension() == ".toml") files.push_back(at->path());
  if (error)
    remarks.push_back({folder.empty() ? "content/languages" : folder.string(),
                       "No languages can be read there: " + error.message() + ".",
                       "Phones get English pages. Name a folder with --languages.", 1});
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    auto words = read_words(file, languages.all_.front());
    if (!words)
      remarks.push_back(words.error());
    else if (words->code == languages.all_.front().code)
      languages.all_.front() = std::move(*words);
    else
      languages.all_.push_back(std::move(*words));
  }
  return languages;
}

const PhoneWords* PhoneLanguages::of(const std::string& code) const {
  const auto found = std::find_if(all_.begin(), all_.end(),
                                  [&](const PhoneWords& words) { return words.code == code; });
  return found == all_.end() ? nullptr : &*found;
}

const PhoneWords* PhoneLanguages::liked(const std::string& accept_language) const {
  const PhoneWords* best = nullptr;
  double best_weight = 0.0;
  for (std::size_t from = 0; from <= accept_language.size();) {
    const std::size_t end = std::min(accept_language.find(',', from), accept_language.size());
    const std::string one = lower(accept_language.substr(from, end - from));
    from = end + 1;
    const std::size_t begin = one.find_first_not_of(" \t");
    if (begin == std::string::npos) continue;
    const std::size_t semicolon = std::min(one.find(';'), one.size());
    std::string code = one.substr(begin, std::min(semicolon, one.size()) - begin);
    code.erase(std::min(code.find_first_of(" \t-_"), code.size()));
    double weight = 1.0;
    if (const std::size_t q = one.find("q=", semicolon); q != std::string::npos)
      weight = std::strtod(one.c_str() + q + 2, nullptr);
    const PhoneWords* words = of(code);
    if (words == nullptr || !(weight > best_weight)) continue;
    best = words;
    best_weight = weight;
  }
  return best;
}

}  // namespace onggi::phone
