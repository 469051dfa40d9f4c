#include "kiosk/collection/content/keepsake_names.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "engine/math/random.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::content {

namespace {

using Table = toml::TomlReader::Table;

constexpr std::size_t kFewest = 8;        // words in a list
constexpr std::size_t kLongestWord = 96;  // bytes, with its forms
constexpr int kTries = 64;

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (c == at)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

/// "2 garza": the form that adjectives take, and the word. Without a number it is the first.
std::pair<std::size_t, std::string> thing_of(const std::string& written) {
  if (written.size() > 2 && written[0] >= '1' && written[0] <= '3' && written[1] == ' ')
    return {static_cast<std::size_t>(written[0] - '1'), written.substr(2)};
  return {0, written};
}

std::string form_of(const std::string& written, std::size_t form) {
  const std::vector<std::string> forms = split(written, '/');
  return forms[std::min(form, forms.size() - 1)];
}

/// Letters that are typed without their accents.
constexpr std::pair<std::string_view, std::string_view> kPlain[] = {
    {"á", "a"},  {"à", "a"}, {"â", "a"}, {"ä", "a"}, {"é", "e"}, {"è", "e"}, {"ê", "e"},
    {"ë", "e"},  {"í", "i"}, {"î", "i"}, {"ï", "i"}, {"ó", "o"}, {"ô", "o"}, {"ö", "o"},
    {"ú", "u"},  {"ù", "u"}, {"û", "u"}, {"ü", "u"}, {"ñ", "n"}, {"ç", "c"}, {"ß", "ss"},
    {"œ", "oe"}, {"É", "e"}, {"Ä", "a"}, {"Ö", "o"}, {"Ü", "u"}, {"أ", "ا"}, {"إ", "ا"},
    {"آ", "ا"},  {"’", ""},  {"َ", ""},   {"ُ", ""},   {"ِ", ""},   {"ّ", ""},   {"ْ", ""},
    {"ً", ""},    {"ٌ", ""},   {"ٍ", ""}};

/// Lower case, without accents, spaces and signs.
std::string folded(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const auto known = std::find_if(std::begin(kPlain), std::end(kPlain), [&](const auto& one) {
      return std::string_view(text).substr(i).starts_with(one.first);
    });
    if (known != std::end(kPlain)) {
      out += known->second;
      i += known->first.size();
      continue;
    }
    const char c = text[i++];
    if (c >= 'A' && c <= 'Z')
      out += static_cast<char>(c + ('a' - 'A'));
    else if (static_cast<unsigned char>(c) >= 0x80 || (c >= 'a' && c <= 'z') ||
             (c >= '0' && c <= '9'))
      out += c;
  }
  return out;
}

}  // namespace

KeepsakeNames::Read KeepsakeNames::read(const std::filesystem::path& file,
                                        const std::vector<std::string>& languages) {
  Read out;
  toml::TomlReader reader(file);
  auto root = reader.root();
  Table order = root.child("order");
  for (const std::string& code : order.keys())
    if (std::string text; order.text(code, text)) {
      const bool whole = std::all_of(kLists.begin(), kLists.end(), [&](const char* list) {
        return text.find("{" + std::string(list) + "}") != std::string::npos;
      });
      if (whole) {
        out.names.order_[code] = text;
        out.names.languages_.push_back(code);
      } else {
        order.complain(code, "A name needs all three words.",
                       "Write " + code + " = \"{first} {second} {thing}\", in its own order.");
      }
    }
  for (const std::string& code : languages)
    if (reader.ok() && !out.names.order_.contains(code))
      out.notes.push_back({file.string(),
                           "Keepsakes have no names in the language \"" + code + "\".",
                           "Write an order in it, and each word; until then names are English."});
  for (std::size_t k = 0; k < kLists.size(); ++k) {
    Table list = root.child(kLists[k]);
    std::set<std::pair<std::string, std::string>> said;
    for (const std::string& id : list.keys()) {
      Table entry = list.child(id);
      Word word{id, {}};
      for (const std::string& code : entry.keys()) {
        std::string text;
        if (!entry.text(code, text)) continue;
        if (text.empty() || text.size() > kLongestWord)
          entry.complain(code, "A word with its forms has 1 to 96 bytes.", "Write a shorter word.");
        else if (!said.emplace(code, text).second)
          entry.complain(code, "\"" + text + "\" stands twice in this list.",
                         "Use another word, so that two names never sound alike.");
        else
          word.in[code] = text;
      }
      for (const auto& [code, any] : out.names.order_)
        if (!word.in.contains(code))
          entry.complain("", "The word has nothing in the language \"" + code + "\".",
                         "Write " + code + " = \"...\".");
      if (word.in.contains("en")) out.names.words_[k].push_back(std::move(word));
    }
    if (reader.ok() && out.names.words_[k].size() < kFewest)
      root.complain(kLists[k], "The list has fewer than 8 words.",
                    "Write more, so that keepsakes do not run out of names.");
  }
  root.finish();
  out.problems = reader.problems();
  out.keys_checked = reader.keys_checked();
  return out;
}

bool KeepsakeNames::any() const {
  return order_.contains("en") &&
         std::all_of(words_.begin(), words_.end(), [](const auto& list) { return !list.empty(); });
}

std::string KeepsakeNames::pick(std::uint64_t seed, const std::set<std::string>& taken) const {
  if (!any()) return {};
  const auto name = [&](std::size_t n) {
    std::string id;
    for (const auto& list : words_) {
      id += (id.empty() ? "" : "-") + list[n % list.size()].id;
      n /= list.size();
    }
    return id;
  };
  const std::size_t all = words_[0].size() * words_[1].size() * words_[2].size();
  Random random(seed);
  for (int i = 0; i < kTries; ++i)
    if (std::string id = name(random.bits() % all); !taken.contains(id)) return id;
  for (std::size_t n = 0; n < all; ++n)
    if (std::string id = name(n); !taken.contains(id)) return id;
  return {};
}

std::string KeepsakeNames::said(const std::string& id, const std::string& language) const {
  const std::vector<std::string> ids = split(id, '-');
  std::array<const Word*, 3> words{};
  for (std::size_t k = 0; k < words.size() && ids.size() == words.size(); ++k)
    for (const Word& word : words_[k])
      if (word.id == ids[k]) words[k] = &word;
  if (std::ranges::find(words, nullptr) != words.end()) {
    std::string plain = id;
    std::replace(plain.begin(), plain.end(), '-', ' ');
    return plain;
  }
  const bool whole = order_.contains(language) && std::ranges::all_of(words, [&](const Word* word) {
                       return word->in.contains(language);
                     });
  const std::string code = whole ? language : "en";
  const auto [form, thing] = thing_of(words[2]->in.at(code));
  std::string name = order_.at(code);
  const std::array<std::string, 3> parts{form_of(words[0]->in.at(code), form),
                                         form_of(words[1]->in.at(code), form), thing};
  for (std::size_t k = 0; k < kLists.size(); ++k) {
    const std::string place = "{" + std::string(kLists[k]) + "}";
    if (const std::size_t at = name.find(place); at != std::string::npos)
      name.replace(at, place.size(), parts[k]);
  }
  return name;
}

bool KeepsakeNames::matches(const std::string& id, const std::string& typed) const {
  const std::string wanted = folded(typed);
  if (wanted.empty()) return false;
  if (folded(id).find(wanted) != std::string::npos) return true;
  return std::ranges::any_of(languages_, [&](const std::string& code) {
    return folded(said(id, code)).find(wanted) != std::string::npos;
  });
}

bool KeepsakeNames::is_called(const std::string& id, const std::string& typed) const {
  const std::string wanted = folded(typed);
  return !wanted.empty() &&
         (folded(id) == wanted || std::ranges::any_of(languages_, [&](const std::string& code) {
            return folded(said(id, code)) == wanted;
          }));
}

std::filesystem::path names_file(const std::filesystem::path& exhibit) {
  std::error_code ignored;
  const std::filesystem::path site = files::site_exhibit(exhibit).parent_path().parent_path();
  if (const auto own = site / "content" / "names.toml";
      !site.empty() && std::filesystem::is_regular_file(own, ignored))
    return own;
  const auto root = files::program_root();
  return root ? *root / "content" / "names.toml" : site / "content" / "names.toml";
}

}  // namespace onggi::content
