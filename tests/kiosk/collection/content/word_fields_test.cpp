#include "kiosk/collection/content/word_fields.h"

#include <gtest/gtest.h>

#include "kiosk/collection/content/language.h"

namespace onggi::content::word_fields_test {
namespace {

TEST(word_fields, are_every_text_of_the_program_with_its_english) {
  const auto english = Language::read("content/languages/en.toml");
  ASSERT_TRUE(english) << to_text(english.error());
  EXPECT_EQ(word_fields().fields.size(), english->keys().size());
  EXPECT_EQ(word_fields().fields.front().name(), "text.all.back");
  const fields::Field* title = fields::find_field(word_fields(), {"text", "attract", "title"});
  ASSERT_NE(title, nullptr);
  EXPECT_EQ(title->words, english->say("attract.title"));
}

}  // namespace
}  // namespace onggi::content::word_fields_test
