#include "kiosk/collection/content/keepsake_names.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/kiosk/ground/files/disk.h"

namespace onggi::content::keepsake_names_test {
namespace {

const std::vector<std::string> kLanguages{"en", "de", "es", "fr", "ja", "ko", "zh", "ar"};

const KeepsakeNames& shipped() {
  static const KeepsakeNames::Read read = KeepsakeNames::read("content/names.toml", kLanguages);
  for (const Problem& p : read.problems) ADD_FAILURE() << to_text(p);
  return read.names;
}

TEST(KeepsakeNames, SayTheSameThreeWordsInEveryLanguageInItsOrderAndGender) {
  const std::string id = "quiet-blue-heron";
  EXPECT_EQ(shipped().said(id, "en"), "quiet blue heron");
  EXPECT_EQ(shipped().said(id, "de"), "stiller blauer Reiher");
  EXPECT_EQ(shipped().said(id, "es"), "garza azul tranquila");
  EXPECT_EQ(shipped().said(id, "fr"), "héron bleu tranquille");
  EXPECT_EQ(shipped().said(id, "ja"), "静かな青いサギ");
  EXPECT_EQ(shipped().said(id, "ko"), "고요한 푸른 왜가리");
  EXPECT_EQ(shipped().said(id, "zh"), "安静的蓝色苍鹭");
  EXPECT_EQ(shipped().said(id, "ar"), "بلشون أزرق هادئ");
  EXPECT_EQ(shipped().said("quiet-blue-leaf", "de"), "stilles blaues Blatt");
  EXPECT_EQ(shipped().said("quiet-blue-star", "ar"), "نجمة زرقاء هادئة");
  EXPECT_EQ(shipped().said(id, "nl"), "quiet blue heron") << "a language without words";
  EXPECT_EQ(shipped().said("quiet-blue-unicorn", "de"), "quiet blue unicorn")
      << "a word that the file has no more";
}

TEST(KeepsakeNames, TheExhibitsLanguagesAllHaveNames) {
  std::set<std::string> codes(shipped().languages().begin(), shipped().languages().end());
  for (const auto& file : std::filesystem::directory_iterator("content/languages"))
    EXPECT_TRUE(codes.contains(file.path().stem().string())) << file.path();
}

TEST(KeepsakeNames, AreFoundInAnyLanguageByOneWordAndWithoutAccentsOrCase) {
  const std::string id = "quiet-blue-heron";
  for (const char* typed :
       {"quiet blue heron", "QUIET-BLUE-HERON", "heron", "quietblueheron", "Stiller blauer Reiher",
        "garza azul", "heron bleu", "héron", "静かな", "왜가리", "苍鹭", "ازرق"})
    EXPECT_TRUE(shipped().matches(id, typed)) << typed;
  EXPECT_FALSE(shipped().matches(id, "red heron"));
  EXPECT_FALSE(shipped().matches(id, ""));
  EXPECT_FALSE(shipped().matches(id, "..."));
}

TEST(KeepsakeNames, NoTwoIdsSoundAlikeInAnyLanguage) {
  for (const std::string& code : kLanguages) {
    std::set<std::string> heard;
    for (std::uint64_t seed = 0; seed < 500; ++seed)
      heard.insert(shipped().said(shipped().pick(seed, {}), code));
    std::set<std::string> ids;
    for (std::uint64_t seed = 0; seed < 500; ++seed) ids.insert(shipped().pick(seed, {}));
    EXPECT_EQ(heard.size(), ids.size()) << code;
  }
}

class SmallNames : public ::testing::Test {
 protected:
  /// Eight words a list, of one language.
  std::filesystem::path write(const std::string& order, int words = 8) {
    const auto file = scratch_.path() / "names.toml";
    std::ofstream out(file);
    out << "[order]\nen = \"" << order << "\"\n";
    for (const char* list : {"first", "second", "thing"}) {
      out << '[' << list << "]\n";
      for (int i = 0; i < words; ++i) {
        const std::string word = std::string(1, list[0]) + static_cast<char>('a' + i);
        out << word << " = { en = \"" << word << "\" }\n";
      }
    }
    return file;
  }
  files::test::ScratchFolder scratch_;
};

TEST_F(SmallNames, NoNameIsGivenTwiceUntilAllAreTaken) {
  const auto read = KeepsakeNames::read(write("{first} {second} {thing}"), {"en"});
  EXPECT_TRUE(read.problems.empty());
  std::set<std::string> taken;
  for (std::uint64_t n = 0; n < 512; ++n) {
    const std::string id = read.names.pick(n % 3, taken);
    ASSERT_FALSE(id.empty());
    EXPECT_TRUE(taken.insert(id).second) << id;
  }
  EXPECT_EQ(read.names.pick(1, taken), "");
}

TEST_F(SmallNames, WhatIsMissingIsNamed) {
  EXPECT_EQ(KeepsakeNames::read(write("{first} {second}"), {}).problems.size(), 1u);
  EXPECT_FALSE(KeepsakeNames::read(write("{first} {second}"), {}).names.any());
  EXPECT_EQ(KeepsakeNames::read(write("{first} {second} {thing}"), {"en", "nl"}).notes.size(), 1u);
  EXPECT_EQ(KeepsakeNames::read(write("{first} {second} {thing}", 7), {}).problems.size(), 3u);
  EXPECT_FALSE(KeepsakeNames::read(scratch_.path() / "none.toml", {}).problems.empty());
}

}  // namespace
}  // namespace onggi::content::keepsake_names_test
