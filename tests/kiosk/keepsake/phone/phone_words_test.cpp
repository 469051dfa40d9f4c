#include "kiosk/keepsake/phone/phone_words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "kiosk/keepsake/phone/visitors_page.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::phone::phone_words_test {
namespace {

namespace fs = std::filesystem;
using files::test::ScratchFolder;
using ::testing::HasSubstr;
using ::testing::Not;

PhoneLanguages exhibits() {
  std::vector<Problem> remarks;
  auto languages = PhoneLanguages::read("content/languages", remarks);
  EXPECT_TRUE(remarks.empty()) << to_text(remarks.front());
  return languages;
}

std::string liked(const PhoneLanguages& languages, const std::string& accept) {
  const PhoneWords* words = languages.liked(accept);
  return words == nullptr ? "" : words->code;
}

TEST(PhoneWords, EveryLanguageOfTheExhibitIsSpokenAndNoneSaysItInEnglish) {
  const PhoneLanguages languages = exhibits();
  std::set<std::string> codes;
  for (const PhoneWords& words : languages.all()) {
    codes.insert(words.code);
    EXPECT_EQ(words.right_to_left, words.code == "ar");
    for (const auto& [key, text] : languages.all().front().texts) {
      EXPECT_NE(words[key.c_str()], "") << words.code << ' ' << key;
      EXPECT_EQ(words[key.c_str()] == text, words.code == "en") << words.code << ' ' << key;
    }
  }
  std::set<std::string> files;
  for (const auto& file : fs::directory_iterator("content/languages"))
    files.insert(file.path().stem());
  EXPECT_EQ(codes, files);
  EXPECT_GE(codes.size(), 8u);
}

TEST(PhoneWords, APhoneIsSpokenToInTheLanguageThatItLikesBestOfThoseThereAre) {
  const PhoneLanguages languages = exhibits();
  EXPECT_EQ(liked(languages, "nn-NO,ko;q=0.8,en;q=0.5"), "ko");
  EXPECT_EQ(liked(languages, "en-GB,ko"), "en");
  EXPECT_EQ(liked(languages, "en;q=0.4, fr ;q=0.9, de;q=0.8"), "fr");
  EXPECT_EQ(liked(languages, "ZH-Hant-TW"), "zh");
  EXPECT_EQ(liked(languages, "ar;q=0"), "") << "wanted not at all";
  EXPECT_EQ(liked(languages, "nds"), "") << "de is no part of it";
  for (const char* nonsense : {"", ",", ";q=1", "*", ",,;;==q", "en;q="})
    EXPECT_EQ(liked(languages, nonsense), "") << nonsense;
}

TEST(PhoneWords, ALanguageThatLacksAWordIsLeftOutInWordsAndEnglishIsAlwaysThere) {
  ScratchFolder folder;
  const auto write = [&](const char* file, const std::string& text) {
    std::ofstream(folder.path() / file) << text;
  };
  const std::string korean = files::test::content("content/languages/ko.toml");
  const auto yes = korean.find("yes = ");
  write("ko.toml", std::string(korean).erase(yes, korean.find('\n', yes) - yes));
  write("xx.toml", "code = \"xx\" nonsense");
  write("fr.toml", "code = \"de\"\nname = \"Deutsch\"\n[text.phone]\n");
  std::vector<Problem> remarks;
  const auto languages = PhoneLanguages::read(folder.path(), remarks);
  ASSERT_EQ(languages.all().size(), 1u);
  EXPECT_EQ(languages.all().front().code, "en");
  ASSERT_EQ(remarks.size(), 3u);
  EXPECT_THAT(to_text(remarks[1]), HasSubstr("phone.yes is missing"));
  EXPECT_THAT(remarks[1].remedy, HasSubstr("yes = \"Yes, delete\""));
  remarks.clear();
  EXPECT_EQ(PhoneLanguages::read(folder.path() / "none", remarks).all().size(), 1u);
  EXPECT_EQ(remarks.size(), 1u);
}

TEST(PhoneWords, AMuseumsWordsAreTextOnThePageWhateverIsInThem) {
  PhoneLanguages languages;
  PhoneWords words = languages.all().front();
  words.texts["title"] = "<script>a</script> & \"b\"";
  const std::string page = visitors_page("t", words, nullptr, languages, {true, true});
  EXPECT_THAT(page, Not(HasSubstr("<script>a")));
  EXPECT_THAT(page, HasSubstr("&lt;script&gt;a&lt;/script&gt; &amp; &quot;b&quot;"));
}

}  // namespace
}  // namespace onggi::phone::phone_words_test
