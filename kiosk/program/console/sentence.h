#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kiosk/ground/files/json.h"

namespace onggi::console {

struct NamedWords;

/// A sentence that the staff's page says in its reader's language. The English one is the key to
/// that (PageWords), so that it is written out and never put together.
struct Sentence {
  Sentence();
  Sentence(std::string words);
  Sentence(std::string words, std::vector<NamedWords> filled_in);

  std::string english;             ///< With {names} for what stands for them.
  std::vector<NamedWords> values;  ///< Those.
  std::string one;                 ///< Of a sentence that counts: the English for one of them.
  std::uint64_t count = 0;  ///< How many; {count} in the words. Without words: the number alone.
  bool theirs = false;      ///< Of another program, in English alone.
};

struct NamedWords {
  std::string name;
  Sentence words;  ///< Without values: a number or a name, the same in every language.
};

/// A sentence that counts.
Sentence counting(std::uint64_t count, std::string one, std::string many,
                  std::vector<NamedWords> values = {});
/// A number, which each language writes in its own way.
Sentence number(std::uint64_t n);
/// What another program said.
Sentence quoted(std::string english);

/// {english, values: {NAME: text or sentence}, one, count, theirs}; what does not count has no one
/// and count.
files::Json json_of(const Sentence& sentence);

}  // namespace onggi::console
