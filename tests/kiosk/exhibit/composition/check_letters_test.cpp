#include "kiosk/exhibit/composition/check_letters.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "kiosk/exhibit/composition/check_exhibit.h"
#include "tests/kiosk/program/commands/temporary_exhibit.h"

namespace onggi::exhibit::check_letters_test {
namespace {

const render::FontCoverage& latin() {
  static const render::FontCoverage fonts = [] {
    std::vector<char32_t> letters;
    for (char32_t letter = 0x21; letter < 0x7F; ++letter) letters.push_back(letter);
    return render::FontCoverage::of(letters);
  }();
  return fonts;
}

TEST(CheckLetters, ALetterThatNoFontHasIsANoteWithItsPlaceItsCodeAndWhatToDo) {
  const commands::ScratchFolder folder;
  const auto file = folder / "vessel.toml";
  std::ofstream(file) << "id = \"a\"\n[label.en]\ntitle = \"A \U00011F02 jar\"\n";
  const LettersReport report = check_letters({file}, latin());
  EXPECT_TRUE(report.problems.empty());
  ASSERT_EQ(report.notes.size(), 1u);
  EXPECT_EQ(to_text(report.notes[0]),
            file.string() +
                ":3:9: No font on this machine has U+11F02 (\U00011F02). Visitors see a "
                "box in its place.\n  Install a package with fonts, such as "
                "fonts-noto-core, or write the text with other letters.");
}

TEST(CheckLetters, ATextWithoutAnyLetterThatAFontHasIsAProblem) {
  const commands::ScratchFolder folder;
  const auto file = folder / "vessel.toml";
  std::ofstream(file) << "title = \"\u00E6\uC6D4 \u6708\u58FA\u00E6\"\n";
  const LettersReport report = check_letters({file}, latin());
  EXPECT_TRUE(report.notes.empty());
  ASSERT_EQ(report.problems.size(), 1u);
  EXPECT_EQ(report.problems[0].what,
            "No font on this machine has U+00E6 (\u00E6), U+C6D4 (\uC6D4), U+6708 (\u6708) and 1 "
            "more. Visitors would see nothing but boxes here.");
}

TEST(CheckLetters, OfFilesThatAreNotTomlNothingIsSaid) {
  const commands::ScratchFolder folder;
  std::ofstream(folder / "vessel.glb") << "title = \"\uC6D4\"\n";
  const LettersReport report =
      check_letters({folder / "vessel.glb", folder / "not there.toml"}, latin());
  EXPECT_TRUE(report.notes.empty() && report.problems.empty());
}

TEST(CheckLetters, ACheckOfAnExhibitNotesThemAndOfATextOfNothingElseIsNotGood) {
  const commands::ScratchFolder folder;
  for (const char* part : {"config", "content"})
    std::filesystem::copy(part, folder / part, std::filesystem::copy_options::recursive);
  const auto exhibit = folder / "config/exhibit.toml";
  std::ofstream(exhibit) << "languages = [\"en\"]\n[title]\nen = \"A \U000F0000\"\n";
  const auto some = check_path(exhibit.string());
  ASSERT_TRUE(some);
  EXPECT_TRUE(some->problems.empty());
  ASSERT_FALSE(some->notes.empty());
  EXPECT_EQ(some->notes.back().where, exhibit.string() + ":3:6");
  std::ofstream(exhibit) << "languages = [\"en\"]\n[title]\nen = \"\U000F0000\"\n";
  const auto all = check_path(exhibit.string());
  ASSERT_TRUE(all);
  ASSERT_EQ(all->problems.size(), 1u);
  EXPECT_EQ(all->problems[0].where, exhibit.string() + ":3:6");
}

}  // namespace
}  // namespace onggi::exhibit::check_letters_test
