#include "kiosk/collection/settings/translations.h"

#include <gtest/gtest.h>

namespace onggi::settings::translations_test {
namespace {

TEST(translations, are_found_by_language_kind_id_and_key_and_come_before_a_things_own_words) {
  Translations said;
  said.languages["de"]["glaze"]["celadon"]["name"] = "Seladon";
  ASSERT_NE(said.find("de", "glaze", "celadon", "name"), nullptr);
  EXPECT_EQ(said.find("de", "glaze", "celadon", "about"), nullptr);
  EXPECT_EQ(said.find("de", "vessel", "celadon", "name"), nullptr);
  EXPECT_EQ(said.find("fr", "glaze", "celadon", "name"), nullptr);
  std::map<std::string, std::string> words{{"en", "Celadon"}, {"de", "Grün"}};
  said.put("glaze", "celadon", "name", words);
  EXPECT_EQ(words, (std::map<std::string, std::string>{{"en", "Celadon"}, {"de", "Seladon"}}));
}

}  // namespace
}  // namespace onggi::settings::translations_test
