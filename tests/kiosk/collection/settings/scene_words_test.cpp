#include "kiosk/collection/settings/scene_words.h"

#include <gtest/gtest.h>

namespace onggi::settings::scene_words_test {
namespace {

TEST(scene_words, ASceneIsToldInItsFilesOwnWordsButForWhereToReadOn) {
  EXPECT_EQ(words_of_scene("# For all: soft clay. What each key means: ../README.md.\n# So that "
                           "one learns.\n# More: docs/paper.md.\n\n# a key's\n[clay]\n"),
            "For all: soft clay. So that one learns.");
  EXPECT_EQ(words_of_scene("# Soft. The exhibit's built_scene names it.\n[clay]\n"), "Soft.");
  EXPECT_EQ(words_of_scene("[clay]\n"), "");
}

}  // namespace
}  // namespace onggi::settings::scene_words_test
