#include "kiosk/exhibit/composition/words.h"

#include <gtest/gtest.h>

#include "kiosk/collection/content/language.h"
#include "kiosk/ground/files/paths.h"

namespace onggi::exhibit::words_test {
namespace {

std::string vessel_line(const std::string& culture, const std::string& date,
                        const std::string& code = "en") {
  settings::Exhibit exhibit;
  exhibit.file = "config/exhibit.toml";
  const auto read =
      content::check_language(files::language_folder(exhibit.file) / (code + ".toml"));
  EXPECT_TRUE(read.problems.empty()) << code;
  content::Label label;
  label.title = "Jar";
  label.culture = culture;
  label.date = date;
  return postcard_words(read.language, label, exhibit).vessel;
}

TEST(PostcardWords, WhereTheVesselIsFromIsNotTakenForWhereTheVisitorsPotWasMade) {
  EXPECT_EQ(vessel_line("Athens", "about 530 BCE"), "The original: Athens, about 530 BCE");
  for (const std::string code : {"ko", "es", "fr", "de", "ja", "zh", "ar"})
    EXPECT_FALSE(vessel_line("Athens", "530", code).starts_with("Athens")) << code;
}

TEST(PostcardWords, AVesselOfOneOrNoWordHasNoEmptyLine) {
  EXPECT_EQ(vessel_line("Athens", ""), "The original: Athens");
  EXPECT_EQ(vessel_line("", "530"), "The original: 530");
  EXPECT_EQ(vessel_line("", ""), "");
}

}  // namespace
}  // namespace onggi::exhibit::words_test
