#include "kiosk/ground/toml/texts_of.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::toml::texts_of_test {
namespace {

std::vector<TextAt> texts_in(const std::string& toml) {
  const files::test::ScratchFolder folder;
  const auto file = folder / "some.toml";
  std::ofstream(file) << toml;
  auto texts = texts_of(file);
  for (TextAt& text : texts) text.where.erase(0, file.string().size());
  return texts;
}

TEST(TextsOf, EveryTextWithItsPlaceInFileOrderWhateverItsKey) {
  const auto texts = texts_in(
      "b = \"달항아리\"  # \"no text\"\na = 3\n[title]\nen = \"A\\u00E9\"\n"
      "list = [\"x\", [\"월\", \"y\"]]\n[[mission]]\nid = \"m\"\n");
  std::string all;
  for (const TextAt& text : texts) all += text.where + " " + text.text + "\n";
  EXPECT_EQ(all, ":1:5 달항아리\n:4:6 A\u00E9\n:5:9 x\n:5:15 월\n:5:20 y\n:7:6 m\n");
}

TEST(TextsOf, AFileThatIsNoTomlHasNone) {
  EXPECT_TRUE(texts_in("a = \"b\nc").empty());
  EXPECT_TRUE(texts_of("/nowhere/at all.toml").empty());
}

}  // namespace
}  // namespace onggi::toml::texts_of_test
