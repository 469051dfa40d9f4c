#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "kiosk/screens/comfort.h"
#include "tests/kiosk/screens/layout_check.h"

// Languages that nobody speaks, made of the English one by a program: what a translation may do to
// a page is seen before there is one.

namespace onggi::screens {
namespace {

namespace fs = std::filesystem;

/// Each word of English, but for the {places}, by `spoken`.
content::Language made(const std::string& code, bool right_to_left,
                       const std::function<std::string(const std::string&)>& spoken) {
  const auto english = content::Language::read("content/languages/en.toml");
  EXPECT_TRUE(english);
  const fs::path folder = fs::temp_directory_path() / ("onggi_trial_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const fs::path file = folder / (code + ".toml");
  std::ofstream out(file);
  out << "code = \"" << code << "\"\nname = \"" << spoken("Trial")
      << "\"\nright_to_left = " << (right_to_left ? "true" : "false") << "\n[text]\n";
  for (const std::string& key : english->keys()) {
    std::string words, word;
    bool place = false;
    for (const char c : english->say(key) + " ") {
      if (c == '{') place = true;
      if (c != ' ' || place) word += c;
      if (c == '}') place = false;
      if (c != ' ' || place) continue;
      words +=
          (words.empty() ? "" : " ") + (word.find('{') == std::string::npos ? spoken(word) : word);
      word.clear();
    }
    std::string quoted;
    for (const char c : words)
      quoted += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    out << '"' << key << "\" = \"" << quoted << "\"\n";
  }
  out.close();
  auto read = content::Language::read(file);
  EXPECT_TRUE(read) << (read ? "" : to_text(read.error()));
  fs::remove_all(folder);
  return read ? *read : content::Language{};
}

/// Longer by two fifths, as German and Finnish are than English, and each word too.
content::Language long_words() {
  return made("xl", false, [](const std::string& word) {
    std::string longer;
    std::size_t letters = 0;
    for (const char c : word) {
      longer += c;
      if (std::isalpha(static_cast<unsigned char>(c)) != 0 && ++letters % 5 % 2 == 1) longer += c;
    }
    return longer;
  });
}

/// In Hebrew letters, which a line sets from the right.
content::Language from_the_right() {
  return made("xr", true, [](const std::string& word) {
    std::string other;
    for (const char c : word) {
      const int letter = std::tolower(static_cast<unsigned char>(c)) - 'a';
      if (letter < 0 || letter > 25)
        other += c;
      else
        other += std::string("\xD7") + static_cast<char>(0x90 + letter);
    }
    return other;
  });
}

void walk_in(const content::Language& language, std::pair<int, int> size, bool larger) {
  Visitor v(9, nullptr, true);
  std::tie(v.width, v.height) = size;
  v.languages = {language, v.languages.front()};
  v.exhibit.screen.larger_text = larger;
  v.keep_today(20);
  v.show();
  walk(v, [&](const std::string& name) { check_layout(v, v.plain, name); });
}

constexpr std::pair<int, int> kTrialSizes[] = {{1080, 1920}, {1920, 1080}, {1280, 720}};

TEST(TrialLanguage, LongWordsAreNowhereCutAndOverlapNothing) {
  const content::Language language = long_words();
  EXPECT_GT(language.say("help.throw").size(), 1.35 * 215);
  for (const auto& size : kTrialSizes) walk_in(language, size, false);
}

TEST(TrialLanguage, WordsFromTheRightAreNowhereCutAndOverlapNothing) {
  const content::Language language = from_the_right();
  for (const auto& size : kTrialSizes) walk_in(language, size, false);
}

TEST(TrialLanguage, WhatIsReadFromTheRightBeginsAtTheRight) {
  Visitor v(30);
  v.languages = {from_the_right(), v.languages.front()};
  v.show();
  v.touch("attract.begin");
  v.frames(1);
  const auto at = [&](const char* id) { return v.visit->control(id)->x; };
  EXPECT_GT(at("back"), at("help"));
  EXPECT_GT(at("help"), at("comfort"));
  EXPECT_GT(at("choose.card.0"), at("choose.card.1"));
  v.key(view::Key::left);
  v.key(view::Key::left);
  EXPECT_NE(v.visit->focus(), "choose.card.0") << "left is onward";
  v.touch("choose.card.0");
  v.touch("choose.throw");
  v.frames(2);
  // The column is on the right, and the pot on the left third.
  EXPECT_GT(at("throw.done"), 640);
  EXPECT_LT(v.frame.pot->camera.centre_x, 640);
  for (const view::Item& item : v.frame.items)
    if (const auto* text = std::get_if<view::Text>(&item)) {
      EXPECT_GT(text->box.x, 640) << text->text;
    }
}

}  // namespace
}  // namespace onggi::screens
