#include "tests/kiosk/visit/screens/trial_language.h"

#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::screens {
namespace {

namespace fs = std::filesystem;

using Spoken = std::string (*)(const std::string&);

/// Each word of `english`, but for the {places}, by `spoken`.
std::string word_by_word(const std::string& english, Spoken spoken) {
  std::string words, word;
  bool place = false;
  for (const char c : english + " ") {
    if (c == '{') place = true;
    if (c != ' ' || place) word += c;
    if (c == '}') place = false;
    if (c != ' ' || place) continue;
    words +=
        (words.empty() ? "" : " ") + (word.find('{') == std::string::npos ? spoken(word) : word);
    word.clear();
  }
  return words;
}

std::string long_word(const std::string& word) {
  std::string longer;
  std::size_t letters = 0;
  for (const char c : word) {
    longer += c;
    if (std::isalpha(static_cast<unsigned char>(c)) != 0 && ++letters % 5 % 2 == 1) longer += c;
  }
  return longer;
}

std::string word_from_the_right(const std::string& word) {
  std::string other;
  for (const char c : word) {
    const int letter = std::tolower(static_cast<unsigned char>(c)) - 'a';
    if (letter < 0 || letter > 25)
      other += c;
    else
      other += std::string("\xD7") + static_cast<char>(0x90 + letter);
  }
  return other;
}

content::Language made(const std::string& code, bool right_to_left, Spoken spoken) {
  const auto english = content::Language::read("content/languages/en.toml");
  EXPECT_TRUE(english);
  const files::test::ScratchFolder folder;
  const fs::path file = folder / (code + ".toml");
  std::ofstream out(file);
  out << "code = \"" << code << "\"\nname = \"" << spoken("Trial")
      << "\"\nright_to_left = " << (right_to_left ? "true" : "false") << "\n[text]\n";
  for (const std::string& key : english->keys()) {
    std::string quoted;
    for (const char c : word_by_word(english->say(key), spoken))
      quoted += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    out << '"' << key << "\" = \"" << quoted << "\"\n";
  }
  out.close();
  auto read = content::Language::read(file);
  EXPECT_TRUE(read) << (read ? "" : to_text(read.error()));
  return read ? *read : content::Language{};
}

}  // namespace

content::Language long_words() { return made("xl", false, long_word); }
content::Language from_the_right() { return made("xr", true, word_from_the_right); }

std::string in_long_words(const std::string& english) { return word_by_word(english, long_word); }
std::string in_letters_from_the_right(const std::string& english) {
  return word_by_word(english, word_from_the_right);
}

}  // namespace onggi::screens
