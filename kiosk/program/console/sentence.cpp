#include "kiosk/program/console/sentence.h"

#include <utility>

namespace onggi::console {

namespace {

using files::Json;

/// A name; what has words of ours is a sentence, however short.
bool is_plain(const Sentence& words) {
  return words.values.empty() && words.one.empty() && !words.theirs;
}

}  // namespace

Sentence::Sentence() = default;
Sentence::Sentence(std::string words) : english(std::move(words)) {}
Sentence::Sentence(std::string words, std::vector<NamedWords> filled_in)
    : english(std::move(words)), values(std::move(filled_in)) {}

Sentence counting(std::uint64_t count, std::string one, std::string many,
                  std::vector<NamedWords> values) {
  Sentence sentence(std::move(many), std::move(values));
  sentence.one = std::move(one);
  sentence.count = count;
  return sentence;
}

Sentence number(std::uint64_t n) {
  Sentence sentence;
  sentence.count = n;
  return sentence;
}

Sentence quoted(std::string english) {
  Sentence sentence(std::move(english));
  sentence.theirs = true;
  return sentence;
}

files::Json json_of(const Sentence& sentence) {
  Json values = Json::object();
  for (const auto& [name, words] : sentence.values)
    values[name] = words.english.empty() ? Json(words.count)
                   : is_plain(words)     ? Json(words.english)
                                         : json_of(words);
  Json out = Json::object({{"english", sentence.english}, {"values", values}});
  if (!sentence.one.empty()) {
    out["one"] = sentence.one;
    out["count"] = sentence.count;
  }
  if (sentence.theirs) out["theirs"] = true;
  return out;
}

}  // namespace onggi::console
