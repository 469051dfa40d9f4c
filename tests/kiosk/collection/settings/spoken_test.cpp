#include "kiosk/collection/settings/spoken.h"

#include <gtest/gtest.h>

namespace onggi::settings {
namespace {

TEST(Spoken, WordsAreTheLanguagesOwnElseEnglishElseTheFirstElseNone) {
  EXPECT_EQ(spoken({{"ar", "a"}, {"en", "e"}, {"ko", "k"}}, "ko"), "k");
  EXPECT_EQ(spoken({{"ar", "a"}, {"en", "e"}, {"ko", "k"}}, "ja"), "e");
  EXPECT_EQ(spoken({{"ar", "a"}, {"ko", "k"}}, "ja"), "a");
  EXPECT_EQ(spoken({}, "ja"), "");
}

}  // namespace
}  // namespace onggi::settings
