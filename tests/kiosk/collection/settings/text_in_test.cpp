#include "kiosk/collection/settings/text_in.h"

#include <gtest/gtest.h>

namespace onggi::settings::text_in_test {
namespace {

TEST(Spoken, WordsAreTheLanguagesOwnElseEnglishElseTheFirstElseNone) {
  EXPECT_EQ(text_in({{"ar", "a"}, {"en", "e"}, {"ko", "k"}}, "ko"), "k");
  EXPECT_EQ(text_in({{"ar", "a"}, {"en", "e"}, {"ko", "k"}}, "ja"), "e");
  EXPECT_EQ(text_in({{"ar", "a"}, {"ko", "k"}}, "ja"), "a");
  EXPECT_EQ(text_in({}, "ja"), "");
}

}  // namespace
}  // namespace onggi::settings::text_in_test
